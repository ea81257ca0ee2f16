// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

/// The normals of the paper (Section 2.2): the direction from a point to its pole, the farthest vertex of its Voronoi
/// cell in space; for a cell without end the mean direction of its edges without end (Amenta and Bern, *Surface
/// reconstruction by Voronoi filtering*, 1999). Vertices from flat tetrahedra do not count (poles.hpp).
///
/// A point whose cell has no usable vertex gets the least-squares plane of its 20 nearest points; the measures
/// "fallback" and "unbounded" count these and the cells without end. `residual` is that of the 12 nearest points from
/// the plane. `sigma` is 0, no point is moved or dropped.
class PoleTangents final : public TangentEstimator {
 public:
  /// O(n log n) on one thread but for the residuals; cannot be cancelled during the tetrahedrization. Throws
  /// SampleError for fewer than three points and for points on a line.
  Tangents estimate(const PointSample& sample, RunContext& context) const override;
};

}  // namespace geodrome
