// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A priority queue of elements 0 ... n - 1, each at most once, lowest key first, equal keys by element. A 4-ary heap
/// that holds the keys, so that comparing touches nothing else. Emptying it leaves it as new.
class IndexedHeap {
 public:
  explicit IndexedHeap(std::size_t count) : place_(count, nowhere) {}

  bool empty() const { return entries_.empty(); }
  double top_key() const { return entries_.front().key; }
  bool holds(Index element) const { return place_[element] != nowhere; }
  std::size_t bytes() const { return place_.capacity() * sizeof(Index) + entries_.capacity() * sizeof(Entry); }

  /// Calls `visit(element)` for a few elements that may come first next.
  template <class Visit>
  void for_each_of_the_next(Visit&& visit) const {
    for (std::size_t i = 0; i < std::min<std::size_t>(entries_.size(), arity + 1); ++i) visit(entries_[i].element);
  }

  /// Inserts an element, or lowers its key; a key that is not lower changes nothing. O(log n).
  void push(Index element, double key) {
    Index at = place_[element];
    if (at == nowhere) {
      at = static_cast<Index>(entries_.size());
      entries_.push_back({});
    } else if (!(key < entries_[at].key)) {
      return;
    }
    rise(at, {key, element});
  }

  /// Removes and returns the first element. O(log n). Not empty.
  Index pop() {
    const Index first = entries_.front().element;
    place_[first] = nowhere;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) sink(last);
    return first;
  }

  void clear() {
    for (const Entry& entry : entries_) place_[entry.element] = nowhere;
    entries_.clear();
  }

 private:
  static constexpr Index nowhere = no_index, arity = 4;
  struct Entry {
    double key;
    Index element;
    bool before(const Entry& other) const { return key < other.key || (key == other.key && element < other.element); }
  };

  void put(Index at, const Entry& entry) { entries_[at] = entry, place_[entry.element] = at; }

  void rise(Index at, const Entry& entry) {
    while (at > 0) {
      const Index parent = (at - 1) / arity;
      if (!entry.before(entries_[parent])) break;
      put(at, entries_[parent]);
      at = parent;
    }
    put(at, entry);
  }

  void sink(const Entry& entry) {
    const auto size = static_cast<Index>(entries_.size());
    Index at = 0;
    for (Index child = 1; child < size; child = arity * at + 1) {
      Index least = child;
      for (Index other = child + 1; other < std::min(child + arity, size); ++other)
        least += (other - least) * static_cast<Index>(entries_[other].before(entries_[least]));
      if (!entries_[least].before(entry)) break;
      put(at, entries_[least]);
      at = least;
    }
    put(at, entry);
  }

  std::vector<Entry> entries_;
  std::vector<Index> place_;
};

}  // namespace geodrome
