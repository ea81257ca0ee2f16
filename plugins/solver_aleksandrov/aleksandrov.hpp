// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "geodrome/settings.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"

namespace geodrome {

/// Distances at most 1 + delta times too long, and never too short, by a graph of Steiner points on bisectors
/// (Aleksandrov, Maheshwari and Sack, J. ACM 52, 2005). PROOF.md has the proof.
///
/// Any mesh: open, non-manifold, unoriented, with faces without area. O(F log(1 / delta) / delta^0.5) nodes,
/// O(F log^2(1 / delta) / delta) edges, which are compared but not stored; a run costs what it reaches.
class AleksandrovSolver : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::pair_queries | Provides::weights |
                                       Provides::factor_any_point | Provides::never_shorter;
  using Settings = aleksandrov::Settings;
  static constexpr auto options = settings_table(
      option("delta", &Settings::delta, "0.05", 1e-4, 1, "", "distances are at most 1 + delta times too long"),
      option("placement", &Settings::placement, "thin", "thin|published",
             {aleksandrov::Placement::thin, aleksandrov::Placement::published},
             "of Steiner points: ours, or that of the paper (denser)"),
      option(
          "triangulation", &Settings::triangulation, "refined", "as_is|flipped|refined",
          {aleksandrov::Triangulation::as_is, aleksandrov::Triangulation::flipped, aleksandrov::Triangulation::refined},
          "of the same surface: the mesh, intrinsic Delaunay, or that without thin faces"),
      option("unguaranteed_thinning", &Settings::thinning, "1", 1, 100, "",
             "steps between Steiner points so many times as long: faster, and NO guarantee above 1"));

  /// `exact` answers the pairs that the index of pair queries leaves open: any exact solver for any mesh.
  AleksandrovSolver(const OptionValues& values, std::shared_ptr<const ShortestPathSolver> exact);

  /// 1 + delta, or no factor with thinning.
  static double factor(const OptionValues* values) noexcept;

  /// O(F log F) and the Steiner points.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;

 private:
  Settings settings_;
  std::shared_ptr<const ShortestPathSolver> exact_;
};

}  // namespace geodrome
