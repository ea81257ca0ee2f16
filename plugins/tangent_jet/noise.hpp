// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "geodrome/run_context.hpp"
#include "plugins/common/points/neighbours.hpp"

namespace geodrome {

/// What the residuals of quadrics tell of the noise of a whole sample, in the units of the input.
struct Noise {
  double sigma = 0;               ///< standard deviation across the surface: an estimate, or a bound if not significant
  bool significant = false;       ///< whether the residuals are noise rather than shape that a quadric leaves out
  std::size_t neighbourhood = 0;  ///< how many neighbours smoothing should average over
  double spacing = 0;             ///< side of the square that one point has, median
};

/// Estimates the noise from quadrics fitted to 10, 20, 40, ... up to 640 neighbours.
///
/// Let s(k) be the median over points of the residual's standard deviation at k neighbours. Noise that is small
/// against the neighbourhood gives the same s for every k; what the quadric leaves out of a smooth shape grows as
/// k^1.5 (third order), at a sharp edge as k^0.5; noise larger than the neighbourhood as k^0.33 at first. So noise is
/// significant if s(20) < 1.45 s(10) and s(40) < 1.6 s(20), if it is alike everywhere (the lowest tenth of the points
/// has half the median or more), and if it is worth a hundredth of the spacing. Then sigma is s at the end of the
/// flattest doubling, taken from small k on, and the neighbourhood that with the least expected error at its centre,
/// or the smallest that leaves less than a twentieth of the spacing.
///
/// Looks at 1,000 points spread along `order` (a spatial order), so it depends on the points, not on their indices;
/// but if there are more, turning the sample changes which, and with them sigma by some percent.
/// A median: outliers must be in less than half of the neighbourhoods. Not significant for fewer than 100 points.
Noise estimate_noise(const Neighbours& neighbours, std::span<const Index> order, RunContext& context);

}  // namespace geodrome
