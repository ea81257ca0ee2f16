// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/control_function.hpp"
#include "geodrome/settings.hpp"

namespace geodrome {

struct ConstantSettings {
  double value;
};

inline constexpr auto constant_options =
    settings_table(option("value", &ConstantSettings::value, "0", 0, 1e100, "units of the input",
                          "psi of every point; 0: 0.8 times the sample's spacing"));

/// The spacing of a sample is the median distance of a point from its neighbour of this rank. The sixth is 1.38 r away
/// on average in a random sample and 1.41 r in a square lattice, with 1 / r^2 points per unit of area; the nearest
/// would be at 0.5 r and r.
inline constexpr std::size_t spacing_rank = 6;

/// psi over the spacing. Reconstructors take what is wider than 2.5 psi for a hole: 0.3 and, in large samples, 0.5 make
/// holes of the thin places of a random sample; from 1 on, thin parts of a shape lose the points that show them.
inline constexpr double spacing_factor = 0.8;

/// A control function that is the same everywhere: phi is the value, psi is the value or, if that is more, 5 sigma of
/// the noise that the tangents state. It is 1/18-Lipschitz as any constant, but knows nothing of the shape: the bound
/// psi <= 1.19 epsilon lfs holds for epsilon = value / (1.19 min lfs) alone.
///
/// Measures: "psi"; "spacing", unless the value is given; "raised_to_noise", the points whose psi the noise decides.
class ConstantControl final : public ControlFunction {
 public:
  explicit ConstantControl(const OptionValues& options) : settings_(constant_options.parsed(options)) {}

  /// O(n log n), O(n) with a given value. Throws SampleError, unless the value is given, if there is but one point or
  /// most points coincide with their neighbours.
  Control evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const override;

 private:
  ConstantSettings settings_;
};

}  // namespace geodrome
