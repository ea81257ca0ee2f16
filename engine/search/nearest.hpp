// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/search/distance_row.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// One search from all sources: for every target its distance from the nearest source.
struct NearestResult {
  std::string csv;  ///< target,distance,source,reach
  std::uint64_t reached = 0, beyond_limit = 0, unreachable = 0, dropped = 0;
  double seconds = 0;
};

/// Throws CapabilityError if a start distance is wanted that the solver does not provide. Isolated and dropped sources
/// reach no other point.
NearestResult find_nearest(const PreparedSolver& solver, std::span<const NamedPoint> sources, const TargetList& targets,
                           double max_distance, RunContext& context);

}  // namespace geodrome
