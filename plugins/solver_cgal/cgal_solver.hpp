// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// Exact distances by CGAL's Surface_mesh_shortest_path (Chen and Han 1990 with the filter of Xin and Wang 2009).
///
/// Needs a manifold, oriented mesh without face weights. CGAL works on a copy moved near the origin and scaled by a
/// power of two, because its tolerances are absolute. Its own errors, and results that cannot be, become
/// NumericalErrors. Memory grows with the number of windows; they are dropped when the run only keeps targets.
class CgalSolver final : public ShortestPathSolver {
 public:
  static constexpr Needs needs = Needs::manifold | Needs::oriented;
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::any_point | Provides::paths | Provides::path_is_distance |
                                       Provides::factor_any_point | Provides::never_shorter;

  /// Copies the mesh for CGAL, O(V + F). Throws CapabilityError for face weights.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
