// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/smooth/fronts/crossing.hpp"
#include "engine/smooth/fronts/ray.hpp"

namespace geodrome {

/// A point that a distance is wanted of.
struct FrontTarget {
  SurfacePoint at;
  Index vertex = no_index;  ///< where it is one: then gradient and bend are wanted too
  PieceEnd end;
};

/// What a neighbour lets expect of the distance at a point beside it, as in a plane.
struct Forecast {
  double squared;  ///< of the distance
  Vec3 half;       ///< half the gradient of that: it points away from the source

  /// The directions differ by less than 6 degrees.
  bool same_way(const Forecast& other) const;
};

/// The distances at the vertices as far as they are known, and how they reach on to points beside them.
class FrontField {
 public:
  explicit FrontField(const EdgeCurves& curves) : curves_(curves) {}

  void clear() { points_.assign(curves_.mesh().vertex_count(), {}); }
  const FrontPoint& operator[](Index v) const { return points_[v]; }
  void set(Index v, const FrontPoint& point) { points_[v] = point; }

  const EdgeCurves& curves() const { return curves_; }
  FrontTarget target(Index v) const;

  /// By a vertex from which fronts go on, of a point with a normal.
  Forecast forecast(Index from, const Vec3& position, const Vec3& normal) const;

  /// The distance of a point whose path comes from the direction `back`: over the first edge there with ends that
  /// fronts go on from and that are reached by one way. Not known if there is none, or the path does not come over it.
  FrontPoint arrive(const FrontTarget& target, Vec3 back) const;

 private:
  struct Met {
    Ray ray;
    EdgeFront front;
    int faces;  // that the ray went through
  };
  std::optional<Met> meet(const FrontTarget& target, const Vec3& back) const;
  std::optional<EdgeFront> front_of(Index half_edge) const;
  FrontPoint beyond(const Met& met, const FrontTarget& target, const Crossing& crossing) const;
  SurfacePoint on_edge(const Met& met, double share) const;
  double bend_beyond(const Met& met, const FrontTarget& target, const Crossing& crossing) const;

  const EdgeCurves& curves_;
  std::vector<FrontPoint> points_;
};

}  // namespace geodrome
