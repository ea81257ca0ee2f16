// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "plugins/solver_schreiber/node_pool.hpp"

namespace geodrome::schreiber {

/// A persistent sequence of items in the plane that moves as a whole: a rope. Short ones are one flat array; longer
/// ones are an AVL tree whose leaves are arrays, with a motion for each right child, so that joining, splitting and
/// moving touch O(log n) nodes. Copies share nodes; a node that nobody else holds is changed where it is.
///
/// An item has `moved(motion)` and a `key`; the least key of any part is known. All items and motions given and
/// returned are in the frame of the sequence. A sequence is not thread-safe; its pool belongs to one thread.
template <class Item>
class Sequence {
 public:
  using Pool = NodePool<Item>;
  static constexpr double none = geodrome::infinity;

  Sequence() = default;
  explicit Sequence(Pool& pool) : pool_(&pool) {}
  Sequence(Pool& pool, const Item& item) : pool_(&pool), root_(pool.leaf(1)) {
    Pool::items(root_)[0] = item;
    Pool::recount(root_);
  }
  /// Makes a sequence of many items. O(n).
  Sequence(Pool& pool, std::span<const Item> items) : pool_(&pool) {
    if (!items.empty()) root_ = built(items);
  }
  Sequence(const Sequence& other) : pool_(other.pool_), root_(other.root_), motion_(other.motion_) {
    if (root_) ++root_->references;
  }
  Sequence(Sequence&& other) noexcept
      : pool_(other.pool_), root_(std::exchange(other.root_, nullptr)), motion_(other.motion_) {}
  Sequence& operator=(Sequence other) noexcept {
    std::swap(pool_, other.pool_), std::swap(root_, other.root_), std::swap(motion_, other.motion_);
    return *this;
  }
  ~Sequence() {
    if (root_) pool_->release(root_);
  }

  std::size_t size() const { return root_ ? root_->count : 0; }
  bool empty() const { return !root_; }
  double least_key() const { return root_ ? root_->least_key : none; }
  /// Tells whether the sequence is one array, which is the fastest to walk along.
  bool is_flat() const { return !root_ || root_->height == 0; }

  /// Moves all items. O(1) for trees; the items of an array are moved as they are, so that they can be read where they
  /// lie.
  void move(const Motion& motion) {
    motion_ = motion * motion_;
    if (is_flat()) settle();
  }

  /// Returns item i. O(log n).
  Item operator[](std::size_t i) const {
    const Node* node = root_;
    if (node->height == 0) return Pool::items(node)[i];
    Motion motion = motion_;
    while (node->height > 0) {
      const auto& inner = Pool::inner(node);
      if (i < inner.left->count) {
        node = inner.left;
      } else {
        i -= inner.left->count;
        motion = motion * inner.motion;
        node = inner.right;
      }
    }
    return Pool::items(node)[i].moved(motion);
  }
  /// Returns item i, without a copy if the sequence is one array, otherwise in `room`.
  const Item& look(std::size_t i, Item& room) const {
    if (root_->height == 0) return Pool::items(root_)[i];
    room = (*this)[i];
    return room;
  }
  Item front() const { return (*this)[0]; }
  Item back() const { return (*this)[size() - 1]; }

  /// Calls `visit(item)` in order. O(n).
  template <class Visit>
  void for_each(Visit&& visit) const {
    if (root_) walk(root_, motion_, visit);
  }

  /// Calls `change(item, to_frame)` with item i as it is stored; `to_frame` moves it to the frame of the sequence.
  /// O(log n).
  template <class Change>
  void update(std::size_t i, Change&& change) {
    root_ = updated(root_, i, motion_, change);
  }
  void set_key(std::size_t i, double key) {
    update(i, [key](Item& item, const Motion&) { item.key = key; });
  }

  /// Returns the first item from `from` on with a key at most `limit`; size() if there is none. O(log n).
  std::size_t first_key_at_most(double limit, std::size_t from) const { return root_ ? find(root_, limit, from) : 0; }

  /// Removes item i. O(log n).
  void erase(std::size_t i) {
    if (leaf_of(i)->count > 1) {
      root_ = without(root_, i);
      return;
    }
    Sequence rest = split(i);
    rest.split(1).swap(rest);
    append(std::move(rest));
  }

  /// Keeps the first i items and returns the others, in the same frame. O(log n).
  Sequence split(std::size_t i) {
    Sequence rest;
    rest.pool_ = pool_;
    if (i >= size()) return rest;
    if (i == 0) {
      swap(rest);
      return rest;
    }
    const bool was_flat = is_flat();
    const Halves halves = split_node(std::exchange(root_, nullptr), i);
    root_ = halves.left;
    rest.root_ = halves.right, rest.motion_ = motion_ * halves.motion;
    if (was_flat) return rest;
    if (is_flat()) settle();
    if (rest.is_flat()) rest.settle();
    return rest;
  }

  /// Appends another sequence of the same frame. O(log n).
  void append(Sequence other) {
    if (other.empty()) return;
    if (empty()) return swap(other);
    Motion motion = motion_.inverse() * other.motion_;
    Node* right = std::exchange(other.root_, nullptr);
    if (right->height > 0 && last_leaf(root_)->count + first_leaf(right)->count <= Pool::leaf_size) {
      const Halves halves = split_node(right, first_leaf(right)->count);  // fill the leaf at the seam
      root_ = joined(root_, halves.left, motion);
      right = halves.right, motion = motion * halves.motion;
    }
    root_ = joined(root_, right, motion);
  }

  void swap(Sequence& other) noexcept {
    std::swap(pool_, other.pool_), std::swap(root_, other.root_), std::swap(motion_, other.motion_);
  }

 private:
  using Node = typename Pool::Node;
  struct Halves {
    Node *left, *right;
    Motion motion;  // from the frame of the right one to that of the left one
  };

  /// Brings an array into the frame of the sequence.
  void settle() {
    if (!root_) return;
    root_ = pool_->own(root_);
    Item* items = Pool::items(root_);
    for (std::size_t i = 0; i < root_->count; ++i) items[i] = items[i].moved(motion_);
    motion_ = {};
  }

  template <class Visit>
  static void walk(const Node* node, const Motion& motion, Visit& visit) {
    if (node->height > 0) {
      const auto& inner = Pool::inner(node);
      walk(inner.left, motion, visit);
      walk(inner.right, motion * inner.motion, visit);
      return;
    }
    const Item* items = Pool::items(node);
    for (std::size_t i = 0; i < node->count; ++i) visit(items[i].moved(motion));
  }

  static std::size_t find(const Node* node, double limit, std::size_t from) {
    if (!(node->least_key <= limit) || from >= node->count) return node->count;
    if (node->height == 0) {
      const Item* items = Pool::items(node);
      while (from < node->count && !(items[from].key <= limit)) ++from;
      return from;
    }
    const auto& inner = Pool::inner(node);
    const std::size_t middle = inner.left->count;
    const std::size_t found = from < middle ? find(inner.left, limit, from) : middle;
    return found < middle ? found : middle + find(inner.right, limit, std::max(from, middle) - middle);
  }

  static const Node* last_leaf(const Node* node) {
    while (node->height > 0) node = Pool::inner(node).right;
    return node;
  }
  static const Node* first_leaf(const Node* node) {
    while (node->height > 0) node = Pool::inner(node).left;
    return node;
  }

  const Node* leaf_of(std::size_t i) const {
    const Node* node = root_;
    while (node->height > 0) {
      const auto& inner = Pool::inner(node);
      const bool is_left = i < inner.left->count;
      if (!is_left) i -= inner.left->count;
      node = is_left ? inner.left : inner.right;
    }
    return node;
  }

  /// Removes item i of a tree. Precondition: its leaf holds others.
  Node* without(Node* node, std::size_t i) {
    node = pool_->own(node);
    if (node->height == 0) {
      Item* items = Pool::items(node);
      std::copy(items + i + 1, items + node->count, items + i);
      --node->count;
    } else {
      auto& inner = Pool::inner(node);
      const std::size_t middle = inner.left->count;
      (i < middle ? inner.left : inner.right) = i < middle ? without(inner.left, i) : without(inner.right, i - middle);
    }
    Pool::recount(node);
    return node;
  }

  template <class Change>
  Node* updated(Node* node, std::size_t i, const Motion& motion, Change& change) {
    node = pool_->own(node);
    if (node->height == 0) {
      Item& item = Pool::items(node)[i];
      const double before = item.key;
      change(item, motion);
      Pool::recount_key(node, before, item.key);
      return node;
    }
    auto& inner = Pool::inner(node);
    const std::size_t middle = inner.left->count;
    if (i < middle)
      inner.left = updated(inner.left, i, motion, change);
    else
      inner.right = updated(inner.right, i - middle, motion * inner.motion, change);
    Pool::recount(node);
    return node;
  }

  Node* built(std::span<const Item> items) {
    if (items.size() > Pool::leaf_size) {
      const std::size_t half = items.size() / 2;
      Node* left = built(items.first(half));
      return pool_->inner(left, built(items.subspan(half)), {});
    }
    Node* leaf = pool_->leaf(items.size());
    std::copy(items.begin(), items.end(), Pool::items(leaf));
    Pool::recount(leaf);
    return leaf;
  }

  // The functions below take over the reference to every node that they get.

  Halves split_node(Node* node, std::size_t i) {
    if (node->height == 0) {
      const std::size_t rest = node->count - i;
      Node* right = pool_->leaf(rest);
      std::copy_n(Pool::items(node) + i, rest, Pool::items(right));
      Node* left = node;
      if (node->references > 1) {
        left = pool_->leaf(i);
        std::copy_n(Pool::items(node), i, Pool::items(left));
        pool_->release(node);
      }
      left->count = static_cast<std::uint32_t>(i);
      Pool::recount(left), Pool::recount(right);
      return {left, right, {}};
    }
    const auto [left, right, motion] = pool_->open(node);
    const std::size_t middle = left->count;
    if (i == middle) return {left, right, motion};
    if (i < middle) {
      const Halves halves = split_node(left, i);
      return {halves.left, joined(halves.right, right, halves.motion.inverse() * motion), halves.motion};
    }
    const Halves halves = split_node(right, i - middle);
    return {joined(left, halves.left, motion), halves.right, motion * halves.motion};
  }

  /// Joins two trees. `motion` leads from the frame of b to that of a, which is also the frame of the result.
  Node* joined(Node* a, Node* b, const Motion& motion) {
    if (a->height == 0 && b->height == 0 && a->count + b->count <= Pool::leaf_size) return fused(a, b, motion);
    if (a->height > b->height + 1 || (b->height == 0 && a->height > 0)) {
      const auto [left, right, inner] = pool_->open(a);
      return balanced(left, joined(right, b, inner.inverse() * motion), inner);
    }
    if (b->height > a->height + 1) {
      const auto [left, right, inner] = pool_->open(b);
      return balanced(joined(a, left, motion), right, motion * inner);
    }
    return pool_->inner(a, b, motion);
  }

  /// Joins two trees with heights that differ by two at most.
  Node* balanced(Node* a, Node* b, const Motion& motion) {
    if (b->height > a->height + 1) {
      const auto [left, right, inner] = pool_->open(b);
      if (left->height <= right->height) return pool_->inner(pool_->inner(a, left, motion), right, motion * inner);
      const auto [first, second, innermost] = pool_->open(left);
      return pool_->inner(pool_->inner(a, first, motion), pool_->inner(second, right, innermost.inverse() * inner),
                          motion * innermost);
    }
    if (a->height > b->height + 1) {
      const auto [left, right, inner] = pool_->open(a);
      if (right->height <= left->height)
        return pool_->inner(left, pool_->inner(right, b, inner.inverse() * motion), inner);
      const auto [first, second, innermost] = pool_->open(right);
      const Motion to_second = inner * innermost;
      return pool_->inner(pool_->inner(left, first, inner), pool_->inner(second, b, to_second.inverse() * motion),
                          to_second);
    }
    return pool_->inner(a, b, motion);
  }

  Node* fused(Node* a, Node* b, const Motion& motion) {
    const std::size_t count = a->count + b->count;
    Node* leaf = pool_->own_with_room(a, count);
    Item* end = Pool::items(leaf) + leaf->count;
    for (std::size_t i = 0; i < b->count; ++i) end[i] = Pool::items(b)[i].moved(motion);
    leaf->count = static_cast<std::uint32_t>(count);
    Pool::recount(leaf);
    pool_->release(b);
    return leaf;
  }

  Pool* pool_ = nullptr;
  Node* root_ = nullptr;
  Motion motion_;
};

}  // namespace geodrome::schreiber
