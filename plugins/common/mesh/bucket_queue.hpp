// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A queue of elements with keys >= 0, about the lowest first. An element may be in it several times; who takes it
/// knows whether an entry still counts. Entries lie in buckets of equal width, a ring of them, and beyond its end in a
/// list. The present bucket is taken in the order in which entries came, until more come into it while it is taken than
/// it had: then its keys differ by more than a few edges, and it becomes a heap. Push and pop cost O(1) where entries
/// spread over many buckets.
class BucketQueue {
 public:
  struct Entry {
    float key;
    Index element;
  };
  static constexpr float buckets_a_unit = 16;  ///< of keys

  bool empty() const { return count_ == 0; }
  void clear();

  void push(Index element, float key) {
    const std::int64_t number = bucket_of(key);
    ++count_;
    if (number <= present_number_)
      push_present({key, element});
    else if (number < present_number_ + static_cast<std::int64_t>(size))
      bucket(number).push_back({key, element}), ++in_ring_;
    else
      beyond_.push_back({key, element}), first_beyond_ = std::min(first_beyond_, number);
  }

  /// Takes the next entry. Precondition: not empty.
  Entry pop() {
    if (taken_ == present_.size()) open_next();
    --count_;
    if (!is_heap_) return present_[taken_++];
    std::pop_heap(present_.begin(), present_.end(), later);
    const Entry first = present_.back();
    present_.pop_back();
    return first;
  }

  /// Calls `visit(element)` for the one that will be taken after `count` others, if that is known.
  template <class Visit>
  void look_ahead(std::size_t count, Visit&& visit) const {
    const std::size_t place = is_heap_ ? count : taken_ + count;
    if (place < present_.size()) return visit(present_[place].element);
    const std::vector<Entry>& next = ring_[place_of(present_number_ + 1)];
    if (place - present_.size() < next.size()) visit(next[place - present_.size()].element);
  }

  std::size_t bytes() const;

 private:
  static constexpr std::size_t size = 1024;
  static constexpr float farthest = 1e15F;  ///< all beyond it is one bucket
  static constexpr std::int64_t nowhere = std::numeric_limits<std::int64_t>::max();

  static bool later(const Entry& a, const Entry& b) { return a.key != b.key ? b.key < a.key : b.element < a.element; }
  static std::int64_t bucket_of(float key) {
    return static_cast<std::int64_t>(std::min(key, farthest) * buckets_a_unit);
  }
  static std::size_t place_of(std::int64_t number) { return static_cast<std::size_t>(number) % size; }
  std::vector<Entry>& bucket(std::int64_t number) { return ring_[place_of(number)]; }
  void push_present(Entry entry) {
    present_.push_back(entry);
    if (is_heap_)
      std::push_heap(present_.begin(), present_.end(), later);
    else if (present_.size() > enough_)
      make_heap();
  }
  void make_heap();
  void open_next();

  std::vector<Entry> present_;  ///< the present bucket
  std::size_t taken_ = 0;       ///< so many of them are taken; 0 in a heap
  std::size_t enough_ = 0;      ///< with more than so many entries it becomes a heap
  bool is_heap_ = false;
  std::vector<std::vector<Entry>> ring_ = std::vector<std::vector<Entry>>(size);
  std::vector<Entry> beyond_, coming_;  ///< coming: from beyond into the ring
  std::int64_t present_number_ = -1, first_beyond_ = nowhere;
  std::size_t count_ = 0, in_ring_ = 0;
};

}  // namespace geodrome
