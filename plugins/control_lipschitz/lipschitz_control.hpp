// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/control_function.hpp"
#include "geodrome/settings.hpp"
#include "plugins/common/points/noise_floor.hpp"

namespace geodrome {

struct LipschitzSettings {
  bool cap;
};

inline constexpr auto lipschitz_options =
    settings_table(option("cap", &LipschitzSettings::cap, "on",
                          "limit phi to 1.5 times the median of the 17 nearest points; off: as in the paper"));

/// phi' = phi_factor phi bounds the restricted Voronoi cell (Lemma 2, Corollary 4).
inline constexpr double phi_factor = 1.0005;
/// The slope of equation (1); below 1/18 (Lemma 5).
inline constexpr double psi_slope = 1.19 / 22;

/// The control function of Section 2.2.2: phi by planar Voronoi cells (Theorem 3), capped, and
/// psi(s) = max over s' of phi'(s') - 1.19/22 |ss'| (equation (1)), bitwise that of the plain double loop.
///
/// The cap replaces phi by 1.5 times the median phi of the 17 nearest points (with ties), where it is larger: one
/// outlier or one bad normal would otherwise decide psi everywhere. A point both `unbounded` and capped is `unbounded`;
/// the measures "unbounded" and "capped" count both. "raised_to_noise" counts the points whose psi equation (1) gives
/// below `noise_factor` sigma; the paper's guarantee does not cover a sample with noise.
class LipschitzControl final : public ControlFunction {
 public:
  explicit LipschitzControl(const OptionValues& options) : settings_(lipschitz_options.parsed(options)) {}

  /// Needs unit normals. O(n log n) typically. Throws SampleError if there are points but a cell that no other limits.
  Control evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const override;

 private:
  LipschitzSettings settings_;
};

}  // namespace geodrome
