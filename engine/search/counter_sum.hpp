// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

#include "engine/search/prepared_solver.hpp"

namespace geodrome {

/// A counter whose values are combined by maximum.
inline bool is_largest(std::string_view counter) { return counter.starts_with("largest_"); }

/// Adds the counters of searches up; those that are named "largest_..." are combined by maximum. Thread-safe.
class CounterSum {
 public:
  void add(const PreparedSolver& solver, const ShortestPathMap& map) {
    const std::lock_guard lock(mutex_);
    cross_boundary(solver.plugin.info, [&] {
      for (const Counter& counter : map.counters()) {
        std::uint64_t& sum = sums_[counter.name];
        sum = is_largest(counter.name) ? std::max(sum, counter.value) : sum + counter.value;
      }
    });
  }
  std::map<std::string, std::uint64_t> sums() const {
    const std::lock_guard lock(mutex_);
    return sums_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::uint64_t> sums_;
};

}  // namespace geodrome
