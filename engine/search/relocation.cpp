// SPDX-License-Identifier: MIT
#include "engine/search/relocation.hpp"

#include <algorithm>

#include "interfaces/internal/closest_point_tree.hpp"

namespace geodrome {

namespace {

/// More new faces than this are no local change: an R-tree of the whole surface is cheaper than going through them.
constexpr std::size_t most_fresh = 1000;

/// The distances to a box and to a triangle in it are rounded differently, by a few units in the last place.
constexpr double box_slack = 1e-12;

/// Where two surfaces differ: faces of the old one that are no more, and of the new one that were not; ascending.
struct Difference {
  std::vector<Index> gone, fresh;
};

Difference compare(std::span<const Triangle> from, std::span<const Triangle> to) {
  Difference difference;
  const std::size_t common = std::min(from.size(), to.size());
  for (Index f = 0; f < common; ++f)
    if (from[f] != to[f]) difference.gone.push_back(f), difference.fresh.push_back(f);
  for (auto f = static_cast<Index>(common); f < from.size(); ++f) difference.gone.push_back(f);
  for (auto f = static_cast<Index>(common); f < to.size(); ++f) difference.fresh.push_back(f);
  return difference;
}

/// The box of some faces.
class Box {
 public:
  Box(const SurfaceMesh& mesh, const std::vector<Index>& faces) {
    for (const Index face : faces)
      for (const Vec3& p : mesh.corners(face)) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
      }
  }
  double squared_distance(const Vec3& p) const {
    return squared_norm({beyond(p.x, low_.x, high_.x), beyond(p.y, low_.y, high_.y), beyond(p.z, low_.z, high_.z)});
  }

 private:
  static double beyond(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }
  Vec3 low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

void put(Place& place, const SurfacePoint& at, const SurfaceMesh& mesh) {
  place.at = at;
  place.vertex = mesh.vertex_at(at);
}

void locate_all(std::span<NamedPoint> places, const MeshPtr& to) {
  const SurfaceLocator locator(to);
  for (NamedPoint& named : places)
    if (Place& place = named.place; place.state == Place::State::on_surface)
      put(place, locator.closest(place.position).at, *to);
}

}  // namespace

void relocate(std::span<NamedPoint> places, const SurfaceMesh& from, const SurfaceLocator& locator, const MeshPtr& to) {
  const auto [gone, fresh] = compare(from.triangles(), to->triangles());
  if (fresh.size() > most_fresh) return locate_all(places, to);
  const Box box(*to, fresh);
  for (NamedPoint& named : places) {
    Place& place = named.place;
    if (place.state != Place::State::on_surface) continue;
    // The closest point of the faces that stayed: the old one, or one sought without those that are no more.
    Index face = place.at.face;
    if (std::ranges::binary_search(gone, face)) face = locator.closest(place.position, gone).at.face;
    detail::FacePoint best;
    if (face != no_index) best = detail::closest_on_face(*to, face, place.position);
    if (box.squared_distance(place.position) <= best.point.squared_distance * (1 + box_slack))
      for (const Index other : fresh) {
        const detail::FacePoint candidate = detail::closest_on_face(*to, other, place.position);
        if (best.face == no_index || precedes(candidate, best)) best = candidate;
      }
    put(place, best.at(), *to);
  }
}

}  // namespace geodrome
