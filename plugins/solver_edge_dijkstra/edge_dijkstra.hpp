// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// Shortest paths along the edges of the mesh: an upper bound of the distance without a bounded factor, on any mesh:
/// non-manifold, unoriented, open. Points that are no vertices are joined by straight segments to the corners of the
/// faces that hold them, and to each other within a face. O(E log V) a run, nothing allocated from run to run.
class EdgeDijkstra final : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::never_shorter;

  /// Builds the graph, O(F log F). Throws CapabilityError for face weights.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
