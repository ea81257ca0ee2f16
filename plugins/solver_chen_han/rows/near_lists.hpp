// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/settings.hpp"

namespace geodrome::chen_han {

/// For every vertex the vertices nearest to it with their distances, rounded up: the steps of which upper bounds of all
/// distances are made. Immutable.
class NearLists {
 public:
  struct Entry {
    Index vertex;
    float length;  ///< at least the distance
  };

  /// Searches from every vertex for `count` others, on up to `context.threads()` threads. Throws Cancelled.
  NearLists(const PackedMesh& surface, const Settings& settings, std::size_t count, RunContext& context);

  std::span<const Entry> operator[](Index vertex) const {
    return {entries_.data() + std::size_t{vertex} * count_, size_[vertex]};
  }
  std::size_t bytes() const { return entries_.size() * sizeof(Entry) + size_.size() * sizeof(Index); }

 private:
  std::size_t count_;
  std::vector<Entry> entries_;  ///< count_ places for every vertex
  std::vector<Index> size_;
};

/// What searches take.
struct NearCounts {
  double passes = 0, reached = 0;  ///< of lists of windows, vertices

  /// Returns about how long they took, in units of 10 ns on a processor of 2025.
  double work() const { return 25 * passes + 5 * reached; }
};
/// Searches from some vertices as NearLists does from all, until that took more than `most_work`. Throws Cancelled.
NearCounts count_near(const PackedMesh& surface, const Settings& settings, std::size_t count,
                      std::span<const Index> vertices, double most_work, const RunContext& context);

}  // namespace geodrome::chen_han
