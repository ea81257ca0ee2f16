// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/settings.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "plugins/solver_merged_windows/settings.hpp"

namespace geodrome {

/// Distances at most 1 + delta times too long, and never too short, by windows that are merged with their neighbours
/// where that costs little: after the approximate algorithm of Surazhsky, Surazhsky, Kirsanov, Gortler and Hoppe (TOG
/// 24, 2005), with a proof of the factor in PROOF.md.
///
/// Any mesh: open, non-manifold, unoriented, with faces without area. A run costs what it reaches: O(w log w) for w
/// windows, w ~ F on smooth fine surfaces.
class MergedWindowsSolver final : public ShortestPathSolver {
 public:
  static constexpr Provides provides = Provides::start_distances | Provides::face_sources | Provides::radius_limit |
                                       Provides::target_limit | Provides::any_point | Provides::paths |
                                       Provides::factor_any_point;
  using Settings = merged_windows::Settings;
  static constexpr auto options = settings_table(
      option("delta", &Settings::delta, "1e-3", 1e-6, 1, "", "distances are at most 1 + delta times too long"),
      option("value", &Settings::value, "upper", "upper|middle",
             {merged_windows::Value::upper, merged_windows::Value::middle},
             "of the interval that is known: its upper end, the length of a path, or its middle, within delta / 2 of "
             "the distance either way and nearer as a rule, but without a factor, since it may be too short"));

  explicit MergedWindowsSolver(const OptionValues& values) : settings_(options.parsed(values)) {}

  /// 1 + delta, which implies that no distance is too short; none for the middle, which may be.
  static double factor(const OptionValues* values) noexcept;

  /// O(F log F). Throws CapabilityError for face weights.
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override;

 private:
  Settings settings_;
};

}  // namespace geodrome
