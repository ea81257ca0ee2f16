// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A priority queue of elements 0 ... n - 1, each at most once, lowest key first, equal keys by element. Keys are >= 0
/// and may be +inf, but not NaN; -0 counts as 0. A 4-ary heap that holds the keys, so that comparing touches nothing
/// else. Emptied, it is as new. One per thread.
class IndexedHeap {
 public:
  explicit IndexedHeap(std::size_t count) : place_(count, nowhere) {}

  bool empty() const { return entries_.empty(); }
  /// The lowest key and its element. Precondition: not empty.
  double top_key() const { return entries_.front().key(); }
  Index top() const { return entries_.front().element(); }
  bool holds(Index element) const { return place_[element] != nowhere; }
  std::size_t bytes() const { return place_.capacity() * sizeof(Index) + entries_.capacity() * sizeof(Entry); }

  /// Calls `visit(element)` for a few elements that may come first next.
  template <class Visit>
  void for_each_of_the_next(Visit&& visit) const {
    for (std::size_t i = 0; i < std::min<std::size_t>(entries_.size(), arity + 1); ++i) visit(entries_[i].element());
  }

  /// Inserts an element, or lowers its key; a key that is not lower changes nothing. O(log n).
  void push(Index element, double key) {
    Index at = place_[element];
    if (at == nowhere) {
      at = static_cast<Index>(entries_.size());
      entries_.push_back({});
    } else if (!(key < entries_[at].key())) {
      return;
    }
    rise(at, {key, element});
  }

  /// Removes and returns the first element. Precondition: not empty. O(log n).
  Index pop() {
    const Index first = entries_.front().element();
    place_[first] = nowhere;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (!entries_.empty()) sink(last);
    return first;
  }

  void clear() {
    for (const Entry& entry : entries_) place_[entry.element()] = nowhere;
    entries_.clear();
  }

 private:
  static constexpr Index nowhere = no_index, arity = 4;

  /// Key and element as one number, the bits of the key first, which are in order for keys >= 0: to compare two entries
  /// takes no branch, which could not be foreseen.
  class Entry {
   public:
    Entry() = default;
    Entry(double key, Index element)
        : rank_((Rank{std::bit_cast<std::uint64_t>(key + 0.0)} << 64) | element) {}  // no -0
    double key() const { return std::bit_cast<double>(static_cast<std::uint64_t>(rank_ >> 64)); }
    Index element() const { return static_cast<Index>(rank_); }
    bool before(const Entry& other) const { return rank_ < other.rank_; }

   private:
    __extension__ using Rank = unsigned __int128;
    Rank rank_;
  };

  void put(Index at, const Entry& entry) { entries_[at] = entry, place_[entry.element()] = at; }

  void rise(Index at, const Entry& entry) {
    while (at > 0) {
      const Index parent = (at - 1) / arity;
      if (!entry.before(entries_[parent])) break;
      put(at, entries_[parent]);
      at = parent;
    }
    put(at, entry);
  }

  Index first_of(Index a, Index b) const { return a + (b - a) * static_cast<Index>(entries_[b].before(entries_[a])); }

  void sink(const Entry& entry) {
    const auto size = static_cast<Index>(entries_.size());
    Index at = 0;
    for (Index child = 1; child < size; child = arity * at + 1) {
      Index least = child;
      if (child + arity <= size)
        least = first_of(first_of(child, child + 1), first_of(child + 2, child + 3));
      else
        while (++child < size) least = first_of(least, child);
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
