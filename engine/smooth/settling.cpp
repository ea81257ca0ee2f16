// SPDX-License-Identifier: MIT
#include "engine/smooth/settling.hpp"

#include <algorithm>
#include <vector>

#include "geodrome/detail/point_triangle.hpp"

namespace geodrome {

namespace {

/// Steps square what is missing, which is 1e-3 of an edge at first, and one may be lost at an edge that is crossed.
constexpr int steps = 4;

/// Points that are asked for at once.
constexpr std::size_t at_once = 1024;

/// The orthogonal unit vectors in the plane of a face that points move along.
struct Plane {
  Vec3 side, other, normal, first, second;

  Plane(const SurfaceMesh& mesh, Index face) {
    const auto [p, q, r] = mesh.corners(face);
    side = q - p, other = r - p, normal = cross(side, other);
    first = side / norm(side);
    second = cross(normal, first) / norm(normal);
  }
  void move(std::array<double, 3>& b, const Vec3& by) const {
    const double over = 1 / squared_norm(normal);
    const double b1 = dot(cross(by, other), normal) * over, b2 = dot(cross(side, by), normal) * over;
    b[0] -= b1 + b2, b[1] += b1, b[2] += b2;
  }
};

/// How far to go along both directions so that the tangent plane there is closest.
Vec3 step_to(const Vec3& position, const SmoothPoint& a, const SmoothPoint& b, const Plane& plane) {
  const Vec3 miss = position - a.position;
  const double aa = dot(a.velocity, a.velocity), ab = dot(a.velocity, b.velocity), bb = dot(b.velocity, b.velocity);
  const double am = dot(a.velocity, miss), bm = dot(b.velocity, miss), det = aa * bb - ab * ab;
  const Vec3 step = (am * bb - bm * ab) / det * plane.first + (bm * aa - am * ab) / det * plane.second;
  return is_finite(step) ? step : Vec3{};
}

/// Brings a point that left its face to the closest point of that, seen from the face behind the edge that it crossed
/// if that is trusted. Beyond a border it stays: coordinates cut off at 0 would slide along that.
void come_back(const SmoothCharts& charts, SurfacePoint& at) {
  const int least = static_cast<int>(std::ranges::min_element(at.b) - at.b.begin());
  if (at.b[least] >= 0) return;
  const std::array<Vec3, 3> corners = charts.mesh().corners(at.face);
  const Vec3 point = at.b[0] * corners[0] + at.b[1] * corners[1] + at.b[2] * corners[2];
  at.b = detail::closest_on_triangle(point, corners).b;
  const std::span<const Index> twins = charts.mesh().twins();
  const Index beside = twins.empty() ? no_index : twins[3 * at.face + (least + 1) % 3];
  if (at.b[least] != 0 || beside == no_index || !charts.trusts(beside / 3)) return;
  if (const auto b = charts.on_face(at, beside / 3)) at = {beside / 3, *b};
}

void settle_some(const SmoothCharts& charts, std::span<SettledPoint*> points) {
  std::vector<SmoothPlace> places;
  std::vector<SmoothPoint> above;
  for (int k = 0; k < steps; ++k) {
    places.clear();
    for (const SettledPoint* point : points) {
      const Plane plane(charts.mesh(), point->at.face);
      places.push_back({point->at, plane.first}), places.push_back({point->at, plane.second});
    }
    above.resize(places.size());
    charts.surface().evaluate(places, above);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Plane plane(charts.mesh(), points[i]->at.face);
      plane.move(points[i]->at.b, step_to(points[i]->position, above[2 * i], above[2 * i + 1], plane));
      come_back(charts, points[i]->at);
    }
  }
}

}  // namespace

void settle(const SmoothCharts& charts, std::span<SettledPoint> points) {
  std::vector<SettledPoint*> trusted;
  for (SettledPoint& point : points)
    if (charts.trusts(point.at.face)) trusted.push_back(&point);
  for (std::size_t i = 0; i < trusted.size(); i += at_once)
    settle_some(charts, std::span(trusted).subspan(i, std::min(at_once, trusted.size() - i)));
}

}  // namespace geodrome
