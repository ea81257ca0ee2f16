// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/decimator.hpp"
#include "plugins/common/points/live_points.hpp"

namespace geodrome {

/// What a sample with a boundary cannot spare. The paper, which treats closed surfaces, does not speak of it. Points
/// are packed ones; all is empty for a closed sample.
struct OpenSample {
  std::vector<double> rim_step;  ///< of points on a boundary, how near to each other these may be; 0 elsewhere
  std::vector<char> bent;        ///< points without whose neighbours the shape would be lost

  bool on_rim(Index point) const { return !rim_step.empty() && rim_step[point] > 0; }
  bool is_bent(Index point) const { return !bent.empty() && bent[point] != 0; }
};

/// Finds them among packed points. The rim is what `boundary_spacing` finds, where psi is not over three spacings (as
/// noise makes it: then rims are thinned like the rest). A point is bent if the points within 2.5 psi leave its tangent
/// plane by more than 0.75 psi: another sheet is near, or a radius of curvature is below 4 psi. O(n log n).
OpenSample open_sample(const PointSample& sample, const Control& control, const LivePoints& live, RunContext& context);

}  // namespace geodrome
