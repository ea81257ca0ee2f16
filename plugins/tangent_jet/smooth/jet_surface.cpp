// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/jet_surface.hpp"

#include <array>
#include <cmath>

namespace geodrome {
namespace {

/// A number with its derivatives along two directions d and e of the plane of a face, as far as normals need them.
struct Slopes {
  double value, d, e, dd, de;
};

Slopes operator*(const Slopes& a, const Slopes& b) {
  return {a.value * b.value, a.d * b.value + a.value * b.d, a.e * b.value + a.value * b.e,
          a.dd * b.value + 2 * a.d * b.d + a.value * b.dd, a.de * b.value + a.d * b.e + a.e * b.d + a.value * b.de};
}

/// The plane of a face at a place in it.
struct Chart {
  std::array<Vec3, 3> corner;
  Vec3 point, d, e;  ///< e is d turned by a right angle, counterclockwise seen against the face's normal
};

Chart chart_at(const std::array<Vec3, 3>& corner, const SmoothPlace& place, const Vec3& unit_normal) {
  const auto& b = place.at.b;
  return {corner, b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2], place.direction,
          cross(unit_normal, place.direction)};
}

/// The weights of the corners: squares of barycentric coordinates, which are linear, over their sum.
std::array<Slopes, 3> weights_at(const Chart& chart, const std::array<double, 3>& b, const Vec3& normal) {
  std::array<Slopes, 3> w;
  Slopes sum{};
  const double squared = squared_norm(normal);
  for (int i = 0; i < 3; ++i) {
    const Vec3 gradient = cross(normal, chart.corner[(i + 2) % 3] - chart.corner[(i + 1) % 3]) / squared;
    const Slopes coordinate{b[i], dot(gradient, chart.d), dot(gradient, chart.e), 0, 0};
    w[i] = coordinate * coordinate;
    sum = {sum.value + w[i].value, sum.d + w[i].d, sum.e + w[i].e, sum.dd + w[i].dd, sum.de + w[i].de};
  }
  const double r = 1 / sum.value, d = -r * sum.d, e = -r * sum.e;  // d and e of 1 / sum, over 1 / sum
  const Slopes inverse{r, r * d, r * e, r * (2 * d * d - r * sum.dd), r * (2 * d * e - r * sum.de)};
  for (Slopes& weight : w) weight = weight * inverse;
  return w;
}

/// The way along its normal from the point of the plane of the face to the quartic.
Slopes way_to(const Quartic& quartic, const Chart& chart) {
  const Vec3 offset = chart.point - quartic.base;
  const double xd = dot(quartic.u, chart.d), yd = dot(quartic.v, chart.d);
  const double xe = dot(quartic.u, chart.e), ye = dot(quartic.v, chart.e);
  const Height h = quartic.at(dot(quartic.u, offset), dot(quartic.v, offset));
  return {h.z - dot(quartic.n, offset), h.x * xd + h.y * yd - dot(quartic.n, chart.d),
          h.x * xe + h.y * ye - dot(quartic.n, chart.e), h.xx * xd * xd + 2 * h.xy * xd * yd + h.yy * yd * yd,
          h.xx * xd * xe + h.xy * (xd * ye + xe * yd) + h.yy * yd * ye};
}

}  // namespace

void JetSurface::evaluate(std::span<const SmoothPlace> places, std::span<SmoothPoint> points) const {
  for (std::size_t k = 0; k < places.size(); ++k) {
    const SmoothPlace& place = places[k];
    const std::array<Vec3, 3> corner = mesh_->corners(place.at.face);
    const Vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Chart chart = chart_at(corner, place, normal / norm(normal));
    const std::array<Slopes, 3> weights = weights_at(chart, place.at.b, normal);
    Vec3 position = chart.point, d = chart.d, e = chart.e, dd, de;
    for (int i = 0; i < 3; ++i) {
      const Quartic& quartic = quartics_[mesh_->triangles()[place.at.face][i]];
      const Slopes move = weights[i] * way_to(quartic, chart);
      position = position + move.value * quartic.n;
      d = d + move.d * quartic.n, e = e + move.e * quartic.n;
      dd = dd + move.dd * quartic.n, de = de + move.de * quartic.n;
    }
    const Vec3 across = cross(d, e), turn = cross(dd, e) + cross(d, de);
    const double length = norm(across);
    const Vec3 n = across / length;
    points[k] = {position, n, d, dd, (turn - dot(turn, n) * n) / length};
  }
}

std::size_t JetSurface::bytes() const {
  return sizeof *this + quartics_.capacity() * sizeof(Quartic) + deviations_.capacity() * sizeof(double);
}

}  // namespace geodrome
