// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "engine/smooth/charts.hpp"

namespace geodrome {

/// A point of space, and the surface point that stands for it.
struct SettledPoint {
  Vec3 position;
  SurfacePoint at;
};

/// Moves surface points that are closest on the triangles to points of space, so that what lies above them on the
/// smooth surface is closest to those instead: the closest flat point is off by the third power of an edge, far
/// more than the smooth surface itself. A point stays on its face, or goes to one beside it; those on faces that are
/// not trusted stay. What is looked for is near. O(points).
void settle(const SmoothCharts& charts, std::span<SettledPoint> points);

}  // namespace geodrome
