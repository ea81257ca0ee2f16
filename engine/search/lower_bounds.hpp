// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/search/prepared_solver.hpp"
#include "engine/search/target_list.hpp"
#include "geodrome/lower_bounds.hpp"

/// What is known of true distances from below, l, beside the distances D that a solver's searches give: what the solver
/// states by its extension LowerBounds; without one D / factor, which is D itself for an exact solver.
namespace geodrome {

/// Tells whether a solver gives lower bounds: by the extension, or by a finite factor.
bool has_lower_bounds(const Plugin<ShortestPathSolver>& solver);

/// Throws CapabilityError, naming the solver, unless it gives them.
void demand_lower_bounds(const Plugin<ShortestPathSolver>& solver);

/// Throws OptionError for a metric without lower bounds.
void check_bounds_metric(Metric metric);

/// The lower bounds that a solver states by its extension: a certified interval for every vertex.
class StatedBounds {
 public:
  explicit StatedBounds(const Plugin<ShortestPathSolver>& solver) : table_(solver.extension<LowerBounds>()) {}

  /// False if the solver has no such extension. Nothing else may be called then.
  explicit operator bool() const { return table_ != nullptr; }

  /// Both are to be called inside `cross_boundary`. O(V), and as `LowerBounds::at`.
  std::vector<double> of_vertices(const ShortestPathMap& map, std::size_t vertex_count) const {
    std::vector<double> bounds(vertex_count);
    table_->of_vertices(map, bounds);
    return bounds;
  }
  double at(const ShortestPathMap& map, const SurfacePoint& point) const { return table_->at(map, point); }

 private:
  const LowerBounds* table_;
};

/// The lower bound of the distance along the surface between two places, to which a map of searches from `from` or from
/// several sources gave `found`: +inf where there is no path. `radius` is that of the search; 0 is all that is known
/// where the factor does not hold. To be called inside `cross_boundary`.
double lower_bound(const PreparedSolver& solver, const ShortestPathMap& map, bool source_has_factor, const Place& to,
                   double found, double radius);

/// Fills the lower bounds of a row that `read_row` filled, by the same map, with the start distance and, of a cloud,
/// the straight line: no bound is above its entry; of what lies beyond the limit it is finite, of what is unreachable
/// +inf, of what has no distance NaN. To be called inside `cross_boundary`. Precondition: `has_lower_bounds`.
void read_lower_bounds(const PreparedSolver& solver, const ShortestPathMap* map, const NamedPoint& source,
                       const TargetList& targets, double max_distance, std::span<const double> row,
                       std::span<double> bounds);

}  // namespace geodrome
