// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/common/points/neighbours.hpp"

namespace geodrome {

/// The least-squares plane of some points (principal components).
struct LocalPlane {
  Vec3 normal;          ///< unit; of arbitrary sign
  double residual = 0;  ///< root mean square distance of the points from the plane
  double ratio = 0;     ///< variance across over variance along: 0 on a line
  std::size_t k = 0;    ///< how many neighbours it took to find it

  /// Tells whether all points are on one line up to rounding, so that the normal means nothing.
  bool collinear() const;
};

/// Returns the plane of `base` and the points `around` it. Nothing is lost for a sample far from the origin.
/// O(neighbours).
LocalPlane plane_of(const std::vector<Vec3>& points, const Vec3& base, const std::vector<Neighbour>& around);

/// Returns the plane of point `at` and its `k` nearest neighbours, ties at the last place included. k is doubled while
/// the neighbourhood is thin (variance across below a tenth of that along: it may be a row of a scan), up to 400, and
/// further only while it is on one line up to rounding. Leaves the neighbours in `around`. The result is `collinear`
/// only if the whole sample is.
LocalPlane grown_plane(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around);

/// Throw SampleError: for a sample whose points are on a line; for one of less than three points.
[[noreturn]] void throw_collinear(Index at, std::size_t sample_size);
void require_three_points(std::size_t sample_size);

}  // namespace geodrome
