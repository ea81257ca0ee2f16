// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/options.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"

namespace geodrome {

/// Distances at most 1 + delta times too long, and never too short, by a graph of Steiner points on bisectors
/// (Aleksandrov, Maheshwari and Sack, J. ACM 52, 2005). PROOF.md has the proof.
///
/// Any mesh: open, non-manifold, unoriented, with faces without area. O(F log(1 / delta) / delta^0.5) nodes,
/// O(F log^2(1 / delta) / delta) edges, which are compared but not stored; a run costs what it reaches.
class AleksandrovSolver final : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::path_is_distance | Provides::pair_queries | Provides::weights |
                                       Provides::factor_any_point | Provides::never_shorter;
  static constexpr OptionSpec options[] = {
      number_option("delta", "0.05", 1e-4, 1, "", "distances are at most 1 + delta times too long"),
      choice_option("placement", "thin", "thin|published", "of Steiner points: ours, or that of the paper (denser)"),
      choice_option("triangulation", "refined", "as_is|flipped|refined",
                    "of the same surface: the mesh, intrinsic Delaunay, or that without thin faces"),
      number_option("unguaranteed_thinning", "1", 1, 100, "",
                    "steps between Steiner points so many times as long: faster, and NO guarantee above 1"),
  };

  explicit AleksandrovSolver(const OptionValues& options);

  /// 1 + delta, or no factor with thinning.
  static double factor(const OptionValues* options) noexcept;

  /// O(F log F) and the Steiner points.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;

 private:
  aleksandrov::Settings settings_;
};

}  // namespace geodrome
