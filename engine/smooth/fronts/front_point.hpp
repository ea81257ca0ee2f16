// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "engine/smooth/error_estimate.hpp"

namespace geodrome {

/// What is known at a point of the distance on the smooth surface from a source: its derivatives up to the second
/// order. All else follows: along the gradient the distance is linear, across it the circles around the source bend.
struct FrontPoint {
  double distance = infinity;
  Vec3 gradient;  ///< unit, tangent to the surface
  /// The distance times the geodesic curvature of the circle around the source: 1 in a plane. No number where it is not
  /// known: nothing is measured on from there.
  double bend = std::numeric_limits<double>::quiet_NaN();
  double carried = 0;  ///< estimated: by how much steps since the last path of its own have changed the distance
  LengthError error;   ///< of the distance, but for what steps have changed
  double flat = 0;     ///< of the way here, the length that lies on flat faces
  bool moved = true;   ///< false if a part of its own path stayed above the flat one (SmoothLength)

  bool known() const { return distance < infinity; }
  bool goes_on() const { return bend == bend; }
};

}  // namespace geodrome
