// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

/// Per sample point, in the units of the input: phi (Theorem 3) after capping, and psi (equation (1)). Both are
/// positive and finite except at points that are `dropped`, where both are NaN. The state is that of the tangents, or
/// `unbounded` or `capped`.
struct Control {
  std::vector<double> phi, psi;
  std::vector<PointState> state;
};

/// Stage 2: a Lipschitz control function psi <= 1.19 epsilon lfs (Section 2.2.2, Lemmas 5 and 10).
class GEODROME_VISIBLE ControlFunction {
 public:
  static constexpr const char* stage = "control";
  virtual ~ControlFunction() = default;

  /// `sample` holds the origins of `tangents`, one per point. Thread-safe.
  virtual Control evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const = 0;
};

}  // namespace geodrome
