// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/search/prepared_solver.hpp"
#include "geodrome/engine/distances.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// The targets of a job in the form that every search needs; shared by all threads.
class TargetList {
 public:
  TargetList(std::vector<NamedPoint> targets, const PlacedSurface& surface);
  /// `points[j]`: points of the surface of which the closest one to the source counts for target j; none where it is a
  /// vertex. Such distances have no lower bound.
  TargetList(std::vector<NamedPoint> targets, const std::vector<std::vector<SurfacePoint>>& points);

  std::size_t size() const noexcept { return named_.size(); }
  std::span<const NamedPoint> named() const noexcept { return named_; }
  /// The points of the targets that are no vertices, for Request::targets.
  std::span<const SurfacePoint> points() const noexcept { return points_; }

  /// The surface distance of target `j`, which lies on the surface, from a map. Throws NumericalError if it is no
  /// number that is at least 0, whoever wrote the plugin. To be called inside `cross_boundary`.
  double read(const ShortestPathMap& map, std::size_t j) const;

  /// The smooth surface above target `j`, which is no vertex and lies on a trusted face of a surface that has one.
  const SmoothPoint& above(std::size_t j) const { return above_[first_[j]]; }

  /// All targets that are no vertices and lie on the surface, face by face: those of a face share what is looked up.
  std::span<const std::size_t> by_face() const noexcept { return by_face_; }

  /// True if the surface is an estimate, made from points or smooth: no distance of theirs is below the straight line.
  bool bounded() const noexcept { return bounded_; }
  /// False if the closest of several points may count for a target.
  bool one_point_each() const noexcept { return one_point_each_; }

 private:
  std::vector<NamedPoint> named_;
  std::vector<SurfacePoint> points_;
  std::vector<SmoothPoint> above_;  // points_, on a smooth surface
  std::vector<std::size_t> by_face_;
  std::vector<std::size_t> first_;  // per target: its points in points_ end where those of the next one begin
  bool bounded_, one_point_each_;
};

/// Throws CapabilityError as `demand` if the solver lacks what these sources, targets and limit take. Sources that the
/// rule inserts are vertices.
void check_provides(const PluginInfo& solver, ProjectionRule rule, std::span<const NamedPoint> sources,
                    std::span<const NamedPoint> targets, double max_distance);

}  // namespace geodrome
