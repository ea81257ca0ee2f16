// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {

/// The heat method: K. Crane, C. Weischedel and M. Wardetzky, Geodesics in heat, 2013, by CGAL's Heat_method_3 on an
/// intrinsic Delaunay triangulation. An estimate that errs both ways, smoother than the true distance. From vertices to
/// vertices of a manifold, oriented mesh, which may be open and in several components.
///
/// CGAL's object changes while it solves, so every search that runs at the same time has systems of its own, one for
/// each component; they are kept for the next. A run takes two solves a source.
class Heat final : public ShortestPathSolver {
 public:
  static constexpr Needs needs = Needs::manifold | Needs::oriented;
  static constexpr Provides provides = Provides::nothing;

  /// Factors the systems of all components: superlinear in V. Throws CapabilityError for face weights or another kind
  /// of mesh, InputError for a component without extent or beyond the range of numbers, NumericalError for a face that
  /// is too flat for its angles to be known and for what CGAL fails on.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;
};

}  // namespace geodrome
