// SPDX-License-Identifier: MIT
#pragma once

#include "engine/search/smooth_distances.hpp"

namespace geodrome {

/// Names the sources that are nearest on the smooth surface, where `nearest` has those that are nearest on the
/// triangles with their smooth distances. Another source comes into question for a target if the straight line is
/// shorter than what is known, and the way on the triangles by no more longer than what `farther_for_smooth` allows;
/// these alone are measured, by a search around each source that comes into question for some target, as far as the
/// farthest of those. Throws as `distance_row` and `smooth_row`. O(sources x targets) beside the searches.
void compare_sources(const PreparedSolver& solver, std::span<const NamedPoint> sources, const TargetList& targets,
                     double max_distance, RunContext& context, MeasuredNearest& nearest);

}  // namespace geodrome
