// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/checks/distance_audit.hpp"
#include "engine/checks/interval_audit.hpp"
#include "engine/search/smooth_distances.hpp"
#include "geodrome/engine/named_points.hpp"
#include "geodrome/shortest_path_map.hpp"

namespace geodrome {

/// The distances of a job's targets from the nearest of its sources.
struct NearestResult : MeasuredNearest {
  std::uint64_t reached = 0, beyond_limit = 0, unreachable = 0, dropped = 0;
  double seconds = 0;
  std::vector<double> bounds;                ///< lower, per target; empty if they are not wanted
  std::optional<IntervalFigures> certified;  ///< by the search, if the solver states lower bounds
  std::vector<double> vertices;              ///< what the search found at the vertices, for the audit; none without one
  DistanceAudit audit;
};

/// Searches from all sources and counts what came of it. `with_bounds`: lower bounds are wanted. Throws as
/// `nearest_distances`.
NearestResult find_nearest(const PreparedSolver& solver, const SurfaceMesh& mesh, std::span<const NamedPoint> sources,
                           const TargetList& targets, double max_distance, bool with_bounds, RunContext& context);

/// Lines of target, distance, source, reach; with bounds one more column, lower_bound.
std::string as_csv(const NearestResult& nearest, std::span<const NamedPoint> sources,
                   std::span<const NamedPoint> targets);

}  // namespace geodrome
