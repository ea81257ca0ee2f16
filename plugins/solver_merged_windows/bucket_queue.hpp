// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::merged_windows {

/// A queue of elements with keys >= 0, the lowest first. An element may be in it several times; who takes it knows
/// whether an entry still counts. Entries lie in buckets of equal width, a ring of them, and beyond its end in a list;
/// the present bucket is a heap. Where entries spread over many buckets, a push and a pop cost O(1).
class BucketQueue {
 public:
  struct Entry {
    float key;
    Index element;
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : element < other.element;
    }
  };

  bool empty() const { return count_ == 0; }
  void clear();

  void push(Index element, float key) {
    const std::int64_t number = bucket_of(key);
    ++count_;
    if (number <= present_) {
      heap_.push_back({key, element});
      std::push_heap(heap_.begin(), heap_.end(), later);
    } else if (number < present_ + size) {
      bucket(number).push_back({key, element});
      ++in_ring_;
    } else {
      beyond_.push_back({key, element});
      first_beyond_ = std::min(first_beyond_, number);
    }
  }

  /// Takes an entry with the lowest key. Precondition: not empty.
  Entry pop() {
    if (heap_.empty()) open_next();
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Entry first = heap_.back();
    heap_.pop_back();
    --count_;
    return first;
  }

  /// Calls `visit(element)` for a few that may come next.
  template <class Visit>
  void for_each_of_the_next(Visit&& visit) const {
    for (std::size_t i = 0; i < std::min<std::size_t>(heap_.size(), 4); ++i) visit(heap_[i].element);
  }

  std::size_t bytes() const;

 private:
  static constexpr std::int64_t size = 1024;
  static constexpr float buckets_a_unit = 8;
  static constexpr std::int64_t nowhere = std::numeric_limits<std::int64_t>::max();
  static constexpr float farthest = 1e15F;  ///< all beyond it is one bucket

  static bool later(const Entry& a, const Entry& b) { return b < a; }
  static std::int64_t bucket_of(float key) {
    return static_cast<std::int64_t>(std::min(key, farthest) * buckets_a_unit);
  }
  std::vector<Entry>& bucket(std::int64_t number) { return ring_[static_cast<std::size_t>(number % size)]; }
  void open_next();

  std::vector<Entry> heap_;
  std::vector<std::vector<Entry>> ring_ = std::vector<std::vector<Entry>>(size);
  std::vector<Entry> beyond_;
  std::int64_t present_ = -1, first_beyond_ = nowhere;
  std::size_t count_ = 0, in_ring_ = 0;
};

}  // namespace geodrome::merged_windows
