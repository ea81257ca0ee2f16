// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// Fast marching on triangles: R. Kimmel and J. A. Sethian, Computing geodesic paths on manifolds, 1998. An estimate
/// of first order in the length of edges that errs both ways, on any mesh: non-manifold, unoriented, open, with faces
/// without area. Distances of vertices only. Exact within the faces that hold the source. A run is O(F log V), and
/// costs what it reaches; nothing is allocated from run to run.
class FastMarching final : public ShortestPathSolver {
 public:
  static constexpr Provides provides =
      Provides::start_distances | Provides::face_sources | Provides::radius_limit | Provides::target_limit;

  /// O(F log F). Throws CapabilityError for face weights and for a mesh of 2^30 half-edges or more.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
