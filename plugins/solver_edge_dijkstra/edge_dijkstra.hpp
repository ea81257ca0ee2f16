// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// Shortest paths along the edges of the mesh: an upper bound of the distance without a bounded factor, on any mesh:
/// non-manifold, unoriented, open. Points that are no vertices are joined by straight segments to the corners of the
/// faces that hold them, and to each other within a face. O(E log V) a run, nothing allocated from run to run.
class EdgeDijkstra final : public ShortestPathSolver {
 public:
  static constexpr std::uint64_t provides = start_distances | face_sources | radius_limit | target_limit | any_point |
                                            paths | path_is_distance | never_shorter;

  /// Builds the graph, O(F log F). Throws CapabilityError for face weights.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
