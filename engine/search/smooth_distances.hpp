// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/search/distances.hpp"
#include "engine/smooth/shortening.hpp"
#include "geodrome/engine/distances.hpp"

/// What a search found on the triangles, turned into lengths on the smooth surface over them: each flat path is
/// shortened there.
namespace geodrome {

/// A length may be shorter on the smooth surface than on the triangles: searches with a limit look so much farther. In
/// the bends of coarse samples (genus 2, 3,000 points) it is by up to 1.5 %.
inline constexpr double farther_for_smooth = 1.05;

/// How far a search on the triangles looks for a row with a limit: so much farther, and some edges more, for a row is
/// carried from vertices around its targets. As far as the limit where the metric is flat.
double searched_radius(const PreparedSolver& solver, double max_distance);

/// What became of flat paths, summed up.
struct SmoothFigures {
  std::uint64_t paths = 0;        ///< of a length above 0
  std::uint64_t left = 0;         ///< of which a part stayed above the flat path: no step made it shorter
  double flat = 0, smooth = 0;    ///< lengths of the flat paths, and of what of them lies on trusted faces
  std::uint64_t compared = 0;     ///< of which the flat distance was read
  double correction = 0;          ///< of these, sum of |length / flat - 1|
  double largest_correction = 0;  ///< of these
  double error = 0;               ///< sum of the estimated errors of lengths
  double largest_error = 0;       ///< of an estimated error over the length
  double largest_change = 0;      ///< of a distance, in the units of the input

  /// Of the length of the flat paths, what lies on trusted faces; 0 of none.
  double share() const { return flat > 0 ? smooth / flat : 0; }
  /// Over the paths; 0 of none.
  double mean_correction() const { return compared > 0 ? correction / static_cast<double>(compared) : 0; }
  /// The estimated error over the length, in the mean over the paths, by their lengths: of far pairs; 0 of none.
  double mean_error() const { return flat > 0 ? error / flat : 0; }
  void add(const SmoothLength& path);
  /// Without its flat distance, in whose place `path` has its length.
  void add_alone(const SmoothLength& path);
  void add(const SmoothFigures& other);
};

/// Replaces the flat distances of a row, which `distance_row` read from this map, by smooth ones. Precondition: the
/// solver has a smooth metric and paths, and the map was kept. Throws as `trace_path`, what the surface throws, and
/// NumericalError for a length that is no number. `reading`: how the row was read; without curves of edges: all of it.
SmoothFigures smooth_row(const PreparedSolver& solver, const ShortestPathMap& map, const NamedPoint& source,
                         const TargetList& targets, double max_distance, std::span<double> row,
                         Reading reading = Reading::all);

/// The distances from the nearest of several sources, under the metric of the solver.
struct MeasuredNearest {
  std::vector<Distance> distances;
  std::vector<Distance> flat;           ///< those on the triangles, within `radius`, if the others are smooth
  std::optional<SmoothFigures> smooth;  ///< if they are
  double radius = infinity;             ///< of the search
  std::uint64_t compared = 0;           ///< sources that were searched from by themselves too

  std::span<const Distance> searched() const { return smooth ? flat : distances; }
};

/// As `nearest_distances`, under whatever metric the solver has; where that is smooth, sources that are nearly as near
/// on the triangles are compared (`compare_sources`).
MeasuredNearest measured_nearest(const PreparedSolver& solver, std::span<const NamedPoint> sources,
                                 const TargetList& targets, double max_distance, RunContext& context,
                                 const WatchNearest& watch = {});

/// Replaces a path on the triangles, which `shortest_path` gave, by its curve on the smooth surface. Needs no map.
void smooth_path(const PreparedSolver& solver, const NamedPoint& from, const TargetList& to, PathResult& path);

}  // namespace geodrome
