// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <type_traits>
#include <vector>

#include "geodrome/geometry.hpp"
#include "plugins/solver_schreiber/motion.hpp"

namespace geodrome::schreiber {

/// The memory of the nodes of sequences. Nodes lie in pages and count their references; freed ones are used again.
/// Items are plain data.
template <class Item>
class NodePool {
 public:
  /// The most items of a leaf. Shorter leaves take less memory.
  static constexpr std::size_t leaf_size = 128;

  struct Node {
    std::uint32_t references, count;
    std::uint8_t height, kind;
    double least_key;
  };
  struct Inner : Node {
    Node *left, *right;
    Motion motion;  ///< from the frame of `right` to that of `left`, which is the node's
  };

  NodePool() = default;
  NodePool(const NodePool&) = delete;
  NodePool& operator=(const NodePool&) = delete;

  static Inner& inner(Node* node) { return *static_cast<Inner*>(node); }
  static const Inner& inner(const Node* node) { return *static_cast<const Inner*>(node); }
  static Item* items(Node* leaf) { return static_cast<Leaf*>(leaf)->items; }
  static const Item* items(const Node* leaf) { return static_cast<const Leaf*>(leaf)->items; }

  /// Brings count, height and least key of a node up to date with what it holds.
  static void recount(Node* node) {
    if (node->height > 0) {
      const Inner& in = inner(node);
      node->count = in.left->count + in.right->count;
      node->height = static_cast<std::uint8_t>(1 + std::max(in.left->height, in.right->height));
      node->least_key = std::min(in.left->least_key, in.right->least_key);
      return;
    }
    node->least_key = infinity;
    for (std::size_t i = 0; i < node->count; ++i) node->least_key = std::min(node->least_key, items(node)[i].key);
  }

  /// Updates the least key of a leaf in which one key became another. O(1) unless that was the least.
  static void recount_key(Node* leaf, double before, double key) {
    if (key <= leaf->least_key)
      leaf->least_key = key;
    else if (before == leaf->least_key)
      recount(leaf);
  }

  /// Returns a leaf of `count` items, whose values are unspecified.
  Node* leaf(std::size_t count) {
    std::uint8_t kind = 1;
    while (room(kind) < count) ++kind;
    Node* node = take(kind);
    node->count = static_cast<std::uint32_t>(count);
    node->height = 0;
    return node;
  }
  /// Returns an inner node. Takes over the references to both children.
  Node* inner(Node* left, Node* right, const Motion& motion) {
    Node* node = take(0);
    Inner& in = inner(node);
    in.left = left, in.right = right, in.motion = motion;
    node->height = 1;
    recount(node);
    return node;
  }

  void release(Node* node) {
    if (--node->references > 0) return;
    if (node->height > 0) release(inner(node).left), release(inner(node).right);
    free_[node->kind].push_back(node);
    bytes_in_use_ -= bytes_of(node->kind);
  }

  /// Returns a node with the same content that nobody else holds. Takes over the reference.
  Node* own(Node* node) {
    if (node->references == 1) return node;
    if (node->height == 0) return own_with_room(node, node->count);
    const Inner& in = inner(node);
    ++in.left->references, ++in.right->references;
    Node* copy = inner(in.left, in.right, in.motion);
    --node->references;
    return copy;
  }
  /// Returns a leaf with the same items and room for `count` that nobody else holds. Takes over the reference.
  Node* own_with_room(Node* node, std::size_t count) {
    if (node->references == 1 && room(node->kind) >= count) return node;
    Node* copy = leaf(count);
    std::copy_n(items(node), node->count, items(copy));
    copy->count = node->count, copy->least_key = node->least_key;
    release(node);
    return copy;
  }

  /// Returns the children of an inner node and their motion. The reference to the node becomes references to them.
  std::tuple<Node*, Node*, Motion> open(Node* node) {
    const Inner in = inner(node);
    if (node->references > 1) {
      ++in.left->references, ++in.right->references, --node->references;
    } else {
      free_[node->kind].push_back(node);
      bytes_in_use_ -= bytes_of(node->kind);
    }
    return {in.left, in.right, in.motion};
  }

  std::uint64_t nodes_made() const { return nodes_made_; }
  std::size_t bytes_in_use() const { return bytes_in_use_; }
  std::size_t bytes() const { return pages_.size() * page_bytes; }

 private:
  static_assert(std::is_trivially_copyable_v<Item>);
  struct Leaf : Node {
    Item items[leaf_size];
  };
  static constexpr std::size_t page_bytes = 1 << 16, kinds = 8;

  /// Returns the number of items that a leaf of this kind has room for. Kind 0 is inner nodes.
  static constexpr std::size_t room(std::uint8_t kind) { return std::size_t{1} << kind; }
  static std::size_t bytes_of(std::uint8_t kind) {
    const std::size_t bytes = kind == 0 ? sizeof(Inner) : sizeof(Leaf) - (leaf_size - room(kind)) * sizeof(Item);
    return (bytes + alignof(Inner) - 1) / alignof(Inner) * alignof(Inner);
  }

  Node* take(std::uint8_t kind) {
    Node* node;
    if (free_[kind].empty()) {
      if (page_left_ < bytes_of(kind)) {
        pages_.push_back(std::make_unique_for_overwrite<std::byte[]>(page_bytes));
        page_ = pages_.back().get(), page_left_ = page_bytes;
      }
      node = reinterpret_cast<Node*>(page_);
      page_ += bytes_of(kind), page_left_ -= bytes_of(kind);
    } else {
      node = free_[kind].back();
      free_[kind].pop_back();
    }
    ++nodes_made_;
    bytes_in_use_ += bytes_of(kind);
    node->references = 1, node->kind = kind;
    return node;
  }

  std::array<std::vector<Node*>, kinds> free_;
  std::vector<std::unique_ptr<std::byte[]>> pages_;
  std::byte* page_ = nullptr;
  std::size_t page_left_ = 0, bytes_in_use_ = 0;
  std::uint64_t nodes_made_ = 0;
};

}  // namespace geodrome::schreiber
