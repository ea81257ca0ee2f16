// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "geodrome/run_context.hpp"
#include "plugins/tangent_jet/smooth/jet_points.hpp"

namespace geodrome {

/// Bounds on the number of points that a quartic is fitted to; 512 cost half a millisecond a vertex.
inline constexpr std::size_t fewest_jet_points = 32, most_jet_points = 512;

/// Weights of noisy points fall to exp(-3) at the last.
inline constexpr double noisy_decay = 3;

/// How the jets of a noisy sample are fitted.
struct FitSize {
  std::size_t points = fewest_jet_points;
  int degree = 3;
  double left_out = 0;  ///< by how much such jets are expected to miss the surface if there were no noise
};

/// Of cubics and quartics fitted by weighted least squares to 32, 64, ..., 512 points, those that tell the heights of a
/// noisy surface above `vertices` best: with the least mean square of what noise leaves, by the weights and sigma, and
/// of what they leave out of the shape, by how much more heights change from half the points to all of them than noise
/// makes them change. One choice for the whole sample: a single vertex hardly shows more than noise. Looks at 256 of
/// the vertices. Precondition: sigma > 0.
FitSize best_fit_size(const JetPoints& points, std::span<const Vec3> vertices, RunContext& context);

}  // namespace geodrome
