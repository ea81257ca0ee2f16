// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// The length that rounding errors of distances are relative to: the largest of the distances and of the coordinates,
/// since a distance is not known better than the coordinates are rounded.
class RoundingScale {
 public:
  /// `smallest_weight`: of the faces, which coordinates are multiplied by; 1 for a mesh without weights.
  explicit RoundingScale(double smallest_weight = 1) : smallest_weight_(smallest_weight) {}

  /// Counts distances, but for those that are not finite.
  RoundingScale& distances(std::span<const double> values) {
    for (const double value : values) include(value);
    return *this;
  }

  /// Counts coordinates, but for those that are not finite.
  RoundingScale& points(std::span<const Vec3> positions) {
    for (const Vec3& p : positions)
      for (const double coordinate : {p.x, p.y, p.z}) include(smallest_weight_ * coordinate);
    return *this;
  }

  double value() const { return value_; }

 private:
  void include(double length) {
    if (std::isfinite(length)) value_ = std::max(value_, std::abs(length));
  }

  double smallest_weight_, value_ = 0;
};

}  // namespace geodrome
