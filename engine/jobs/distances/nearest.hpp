// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/checks/distance_audit.hpp"
#include "geodrome/engine/named_points.hpp"
#include "geodrome/shortest_path_map.hpp"

namespace geodrome {

/// The distances of a job's targets from the nearest of its sources.
struct NearestResult {
  std::vector<Distance> distances;  ///< per target
  std::uint64_t reached = 0, beyond_limit = 0, unreachable = 0, dropped = 0;
  double seconds = 0;
  DistanceAudit audit;
};

/// Counts what came of them.
NearestResult nearest_result(std::vector<Distance> distances, double seconds);

/// Lines of target, distance, source, reach.
std::string as_csv(const NearestResult& nearest, std::span<const NamedPoint> sources,
                   std::span<const NamedPoint> targets);

}  // namespace geodrome
