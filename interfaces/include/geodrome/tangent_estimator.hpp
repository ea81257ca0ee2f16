// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "geodrome/geometry.hpp"
#include "geodrome/run_context.hpp"

namespace geodrome {

/// The state of a point after a stage.
enum class PointState : std::uint8_t {
  ok,
  unbounded,  ///< its planar Voronoi cell has no end: a boundary candidate
  capped,     ///< its phi was cut to the neighbourhood's: the paper's guarantee does not cover it
  dropped     ///< taken for an outlier: later stages leave it out, its distances are NaN
};

/// The plane through `origin` with unit `normal`; the normal's sign is arbitrary. `origin` is the point itself, or
/// where an estimator that smooths moved it: the later stages work on the origins, which are pairwise distinct.
/// `residual`: root mean square distance of the neighbours from the fitted surface, in the units of the input.
struct TangentPlane {
  Vec3 origin, normal;
  double residual = 0;
};

/// One plane and state per sample point, and the estimated noise (standard deviation, units of the input, 0 if none).
struct Tangents {
  std::vector<TangentPlane> plane;
  std::vector<PointState> state;
  double sigma = 0;
};

/// Stage 1: tangent planes of the unknown surface at the sample points (Section 2.2).
class GEODROME_VISIBLE TangentEstimator {
 public:
  static constexpr const char* stage = "tangent";
  virtual ~TangentEstimator() = default;

  /// Returns `sample.size()` planes and states. Throws SampleError, naming a point, where the sample spans no plane
  /// (fewer than three points, all on a line). Thread-safe.
  virtual Tangents estimate(const PointSample& sample, RunContext& context) const = 0;
};

}  // namespace geodrome
