// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/tangent_estimator.hpp"
#include "plugins/tangent_jet/smooth/quartic_fit.hpp"

namespace geodrome {

/// The points that quartics are fitted to: a sample without what was dropped, before and after it was smoothed.
struct JetPoints {
  Neighbours places;         ///< the origins of the tangent planes
  std::vector<Vec3> raw;     ///< the sample's own points
  std::vector<Vec3> normal;  ///< of the tangent planes
  double sigma;              ///< the noise that the estimator found, 0 if none

  JetPoints(const PointSample& sample, const Tangents& tangents);
};

/// Fits the quartic of a vertex, over its own tangent plane, to the points within `reach`, but at least the nearest 32
/// and at most 512. Their number is doubled while the residual does not grow with it, as that of noise does not; that
/// of a clean smooth shape grows tenfold. Where it was doubled, and where the estimator found noise, the quartic has
/// a constant. The residual is that of the raw points. `around` is a buffer.
QuarticFit vertex_jet(const JetPoints& points, const Vec3& vertex, double reach, std::vector<Neighbour>& around);

}  // namespace geodrome
