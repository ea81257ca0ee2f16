// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "plugins/solver_chen_han/propagation.hpp"
#include "plugins/solver_chen_han/rows/direct_list.hpp"
#include "plugins/solver_chen_han/rows/direct_run.hpp"

namespace geodrome::chen_han {

/// What direct searches of one surface share. Immutable.
struct DirectGround {
  /// So many near vertices make bounds that are hardly too long, at next to no cost.
  static constexpr std::size_t near_count = 20;

  DirectGround(const PackedMesh& surface, const Settings& settings, RunContext& context)
      : near(surface, settings, near_count, context), angles(surface), longest_edge(longest_edge_of(surface)) {}
  std::size_t bytes() const { return near.bytes() + angles.bytes(); }

  NearLists near;
  CornerAngles angles;
  double longest_edge;  ///< in units of the packed mesh

 private:
  static double longest_edge_of(const PackedMesh& surface) {
    double longest = 0;
    for (Index h = 0; h < 3 * surface.face_count(); ++h) longest = std::max(longest, surface.length(h));
    return longest;
  }
};

/// Finds the direct paths from one vertex after the other. One per thread.
class DirectSearch {
 public:
  /// Surface and ground are kept by reference.
  DirectSearch(const PackedMesh& surface, const Settings& settings, const DirectGround& ground)
      : surface_(surface),
        angles_(ground.angles),
        longest_edge_(ground.longest_edge),
        propagation_(surface, settings),
        direct_(surface, ground.near, ground.angles) {}

  /// Returns the direct paths from a vertex, up to a length, that may be shortest: all that are, and some that are
  /// longer. In any order, valid until the next run. Throws Cancelled.
  std::span<const FoundPath> run(Index source, double limit, const RunContext& context);
  /// The same as a list, which is not complete.
  DirectList list(Index source, double limit, const RunContext& context);

  /// After a run.
  const Propagation& propagation() const { return propagation_; }
  const DirectRun& direct() const { return direct_; }
  std::size_t bytes() const { return propagation_.bytes() + direct_.bytes() + paths_.capacity() * sizeof(FoundPath); }

 private:
  DirectionCode half_turn(Index vertex) const;
  DirectionCode code(Index vertex, double direction) const;
  DirectionCode arrival(Index vertex, const Label& label) const;

  const PackedMesh& surface_;
  const CornerAngles& angles_;
  double longest_edge_;
  Propagation propagation_;
  DirectRun direct_;
  std::vector<FoundPath> paths_;
  std::size_t any_ = 0;
};

}  // namespace geodrome::chen_han
