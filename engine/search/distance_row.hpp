// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// Runs a solver's search across the border to the plugin.
const ShortestPathMap& run_search(const PreparedSolver& solver, Search& search, std::span<const Source> sources,
                                  const Request& request, RunContext& context);

/// A new search of the prepared surface.
std::unique_ptr<Search> make_search(const PreparedSolver& solver);

/// Throws CapabilityError, naming plugin and capability, if the solver does not provide `wanted`; `what` is that in
/// words.
void demand(const PreparedSolver& solver, Provides wanted, const char* what);

/// Throws CapabilityError as `demand` if the solver lacks what these sources, targets and limit take.
void check_provides(const PreparedSolver& solver, std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                    double max_distance);

/// The targets of a job in the form that every row needs; shared by all threads.
class TargetList {
 public:
  TargetList(std::vector<NamedPoint> queries, const PlacedSurface& surface);
  /// `points[j]`: points of the surface of which the closest one to the source counts for target j; none where it is a
  /// vertex. Such distances have no lower bound.
  TargetList(std::vector<NamedPoint> queries, const std::vector<std::vector<SurfacePoint>>& points);

  std::span<const NamedPoint> queries() const noexcept { return queries_; }
  /// The points of the targets that are no vertices, for Request::targets.
  std::span<const SurfacePoint> points() const noexcept { return points_; }

  /// The surface distance of target `j` from a map, +inf at isolated vertices, NaN if dropped. Throws NumericalError if
  /// it is no number >= 0, whoever wrote the plugin. To be called inside `cross_boundary`.
  double read(const ShortestPathMap& map, std::size_t j) const;

  /// What the distance from `source` to target `j` cannot be below: |st| for a cloud, whose surface is an estimate; 0
  /// for a mesh, whose distances stay as they are.
  double lower_bound(const NamedPoint& source, std::size_t j) const;
  /// Whether that is |st|, whatever the solver.
  bool bounded() const noexcept { return estimated_; }

 private:
  std::vector<NamedPoint> queries_;
  std::vector<SurfacePoint> points_;
  std::vector<std::size_t> first_;  // per target: its points in points_ end where those of the next one begin
  bool estimated_;
};

/// Fills one row: the distances of all targets from one source, its start distance added; farther than `max_distance`
/// is +inf, a dropped source's row NaN, an isolated one reaches only itself. Returns the search's counters, valid until
/// its next run; empty if none was needed.
std::span<const Counter> distance_row(const PreparedSolver& solver, Search& search, const NamedPoint& source,
                                      const TargetList& targets, double max_distance, RunContext& context,
                                      std::span<double> row);

}  // namespace geodrome
