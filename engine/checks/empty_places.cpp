// SPDX-License-Identifier: MIT
#include "engine/checks/empty_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/input/point_tree.hpp"
#include "engine/surface/input_rows.hpp"

namespace geodrome {

namespace {

/// So many points around a face tell how densely they lie.
constexpr unsigned counted_points = 64;
/// The points around an empty disc are those up to so many of its radii from its centre.
constexpr double surroundings = 3;
/// A face is looked at in at most so many steps along an edge.
constexpr int most_steps = 12;

/// So many points of n have to be missing in a disc before it counts as empty. A disc in which m points at random are
/// expected is empty with a chance of exp(-m), and there is room for about n of them: exp(-6), and a third more, since
/// the density is an estimate as well.
double missing_not_by_chance(std::size_t points) { return 1.3 * (std::log(static_cast<double>(points)) + 6); }

class Emptiness {
 public:
  Emptiness(const Input& input, const PlacedSurface& surface) : mesh_(*surface.mesh) {
    const std::vector<Index> rows = rows_of_elements(input);
    for_each_live_point(input, surface, [&](Index point, const Place& place) {
      points_.push_back(mesh_.position(place.at)), rows_.push_back(rows[point]);
    });
    tree_ = input::tree_of(points_);
    least_ = missing_not_by_chance(points_.size());
  }

  std::optional<EmptyPlace> widest() const {
    if (points_.size() <= counted_points) return {};
    std::optional<EmptyPlace> widest;
    double most = 0.7;  // of the least radius, which is only about right
    for (Index face = 0; face < mesh_.face_count(); ++face) {
      const Disc disc = widest_in(face);
      if (!(disc.radius > most * disc.least_radius)) continue;
      const double missing = missing_in(disc);
      if (!(missing > least_)) continue;
      most = disc.radius / disc.least_radius;
      widest = {disc.radius, missing, rows_[disc.nearest]};
    }
    return widest;
  }

 private:
  /// The radius of a disc in which so many points are missing, by how far the points around p reach.
  double least_radius(const Vec3& p) const {
    double reach = 0;
    for (auto at = tree_.qbegin(boost::geometry::index::nearest(input::tree_point(p), counted_points));
         at != tree_.qend(); ++at)
      reach = std::max(reach, distance(points_[at->second], p));
    return reach * std::sqrt(least_ / counted_points);
  }

  struct Disc {
    Vec3 centre;
    double radius = 0;
    Index nearest = no_index;  ///< point
    double least_radius = 0;   ///< of a disc there in which too many points would be missing
  };

  /// The widest empty disc around points of a face, none if it cannot be too wide.
  Disc widest_in(Index face) const {
    const Triangle& corners = mesh_.triangles()[face];
    double longest = 0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, distance(mesh_.positions()[corners[i]], mesh_.positions()[corners[(i + 1) % 3]]));
    Disc widest;
    widest.least_radius = least_radius(mesh_.position({face, {1.0 / 3, 1.0 / 3, 1.0 / 3}}));
    // Every corner is a point of the sample, and nothing in a triangle is farther from all its corners.
    if (!(widest.least_radius > 0 && longest / std::numbers::sqrt3 > widest.least_radius)) return widest;
    const double wanted_steps = std::ceil(4 * longest / widest.least_radius);
    const int steps = static_cast<int>(std::min<double>(most_steps, wanted_steps));
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const double b0 = static_cast<double>(i) / steps, b1 = static_cast<double>(j) / steps;
        const Vec3 p = mesh_.position({face, {b0, b1, 1 - b0 - b1}});
        const Index nearest = tree_.qbegin(boost::geometry::index::nearest(input::tree_point(p), 1))->second;
        const double radius = distance(points_[nearest], p);
        if (radius > widest.radius) widest.centre = p, widest.radius = radius, widest.nearest = nearest;
      }
    return widest;
  }

  double missing_in(const Disc& disc) const {
    const std::size_t around = input::places_near(tree_, disc.centre, surroundings * disc.radius).size();
    return static_cast<double>(around) / (surroundings * surroundings - 1);
  }

  const SurfaceMesh& mesh_;
  std::vector<Vec3> points_;
  std::vector<Index> rows_;
  input::PointTree tree_;
  double least_ = 0;  ///< missing points
};

}  // namespace

std::optional<EmptyPlace> widest_empty_place(const Input& input, const PlacedSurface& surface) {
  if (!surface.mesh) return {};
  return Emptiness(input, surface).widest();
}

}  // namespace geodrome
