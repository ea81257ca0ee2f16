// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/tangent_estimator.hpp"
#include "plugins/common/points/neighbours.hpp"

namespace geodrome {

/// The points that quartics are fitted to: a sample without what was dropped, before and after it was smoothed.
struct JetPoints {
  Neighbours places;         ///< the origins of the tangent planes
  std::vector<Vec3> raw;     ///< the sample's own points
  std::vector<Vec3> normal;  ///< of the tangent planes
  double sigma;              ///< the noise that the estimator found, 0 if none

  JetPoints(const PointSample& sample, const Tangents& tangents);
};

}  // namespace geodrome
