// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/decimator.hpp"

namespace geodrome {

/// Algorithm 1 (DECIMATE): takes points in a fixed order, keeps each that is still there, and removes the closed ball
/// of radius psi around it.
///
/// The order is a Fisher-Yates shuffle of the points that are not dropped, driven by std::mt19937_64 seeded with
/// `context.seed()`; the place of element i is the next number modulo i + 1. Balls are closed, as in Corollary 4, so
/// kept points are farther from those kept before them than these points' psi. With a 1/18-Lipschitz psi that leaves
/// |ss'| > 18/19 psi at either end: Lemma 6 with room for rounding.
///
/// Of a sample with a boundary (`boundary_spacing`) the rim is kept, and what a sheet cannot spare (`OpenSample`).
class GreedyDecimation final : public Decimator {
 public:
  /// O(n log n) for Lipschitz psi. Checks Lemma 6 afterwards at every kept point, but for what open samples
  /// keep besides, and throws NumericalError, naming two
  /// points, if it does not hold: psi was no control function. Measures "lemma_6_worst_ratio", the smallest ratio of a
  /// kept point's distance to the nearest other and its psi (above 17/18), if two points are kept.
  std::vector<Index> select(const PointSample& sample, const Control& control, RunContext& context) const override;
};

}  // namespace geodrome
