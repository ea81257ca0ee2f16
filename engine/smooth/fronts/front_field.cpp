// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/front_field.hpp"

#include <algorithm>
#include <cmath>

#include "engine/smooth/fronts/spread.hpp"

namespace geodrome {

namespace {

/// Above this doubt the ends of an edge are not reached by one way: gradients differ by a twentieth and more. Doubts of
/// edges that are crossed by one way are 1e-6 to 1e-3.
constexpr double most_doubt = 3e-3;
/// What a polynomial of degree 5 leaves of what it changes of one of degree 3: measured 0.03 on a torus, 0.06 on a tube
/// with ten edges around it.
constexpr double left_of_doubt = 0.06;
/// The square of the cosine of what is one way.
constexpr double one_way = 0.99;
/// A path that crosses an edge this far outside is looked for at the edge beside it; if it leads back, it runs by the
/// vertex between them, and either edge will do.
constexpr double outside = 0.01, by_the_vertex = 0.2;
/// Pieces of fewer spacings turn by no more than the normals of curve and face differ: nothing is estimated of them.
constexpr double shortest = 0.01;
constexpr int most_tries = 4, most_faces = 6;

}  // namespace

bool Forecast::same_way(const Forecast& other) const {
  const double product = dot(half, other.half);
  return product > 0 && product * product > one_way * squared_norm(half) * squared_norm(other.half);
}

FrontTarget FrontField::target(Index v) const {
  const VertexShape& shape = curves_.vertex(v);
  return {curves_.mesh().at_vertex(v), v, {shape.position, shape.normal, &shape.turn}};
}

Forecast FrontField::forecast(Index from, const Vec3& position, const Vec3& normal) const {
  const FrontPoint& known = points_[from];
  const VertexShape& shape = curves_.vertex(from);
  const Vec3 way = position - shape.position, left = cross(shape.normal, known.gradient);
  const double forward = known.distance + dot(way, known.gradient), aside = known.bend * dot(way, left);
  const Vec3 half = forward * known.gradient + aside * left;
  return {forward * forward + aside * dot(way, left), half - dot(half, normal) * normal};
}

std::optional<EdgeFront> FrontField::front_of(Index half_edge) const {
  const EdgeCurve& curve = curves_.edge(half_edge);
  const FrontPoint &from = points_[curve.from], &to = points_[curve.to];
  if (!curve.trusted || !from.goes_on() || !to.goes_on()) return std::nullopt;
  const EdgeFront front(curve, from, to);
  if (!(front.doubt() < most_doubt)) return std::nullopt;
  return front;
}

std::optional<FrontField::Met> FrontField::meet(const FrontTarget& target, const Vec3& back) const {
  const SurfaceMesh& mesh = curves_.mesh();
  auto ray = target.vertex == no_index ? ray_from(mesh, target.at, back)
                                       : ray_from(mesh, curves_.starting_at(target.vertex), back);
  for (int faces = 1; ray && faces <= most_faces; ++faces, ray = next_face(mesh, *ray)) {
    if (!curves_.charts().trusts(ray->half_edge / 3)) break;
    if (const auto front = front_of(ray->half_edge)) return Met{*ray, *front, faces};
  }
  return std::nullopt;
}

FrontPoint FrontField::arrive(const FrontTarget& target, Vec3 back) const {
  Index before = no_index;
  for (int k = 0; k < most_tries; ++k) {
    const auto met = meet(target, back);
    if (!met) break;
    const EdgeCurve& curve = met->front.curve();
    const double guess = curves_.forward(met->ray.half_edge) ? met->ray.share : 1 - met->ray.share;
    const auto crossing = find_crossing(met->front, target.end, guess);
    if (!crossing) break;
    const double out = met->ray.half_edge == before ? by_the_vertex : outside;
    if (crossing->distance < infinity && crossing->share > -out && crossing->share < 1 + out)
      return beyond(*met, target, *crossing);
    before = met->ray.half_edge;
    const Vec3 &a = curves_.vertex(curve.from).position, &b = curves_.vertex(curve.to).position;
    back = a + crossing->share * (b - a) - target.end.position;
  }
  return {};
}

FrontPoint FrontField::beyond(const Met& met, const FrontTarget& target, const Crossing& crossing) const {
  const EdgeCurve& curve = met.front.curve();
  const FrontPoint &from = points_[curve.from], &to = points_[curve.to];
  const double share = std::clamp(crossing.share, 0.0, 1.0);
  FrontPoint point{
      .distance = crossing.distance,
      .gradient = crossing.gradient,
      .carried = (1 - share) * from.carried + share * to.carried + left_of_doubt * met.front.doubt() * curve.length,
      .error = LengthError::between(from.error, to.error, share),
      .flat = (1 - share) * from.flat + share * to.flat};
  const SmoothCharts& charts = curves_.charts();
  const Index face = met.ray.half_edge / 3;
  const double spacings = crossing.length / charts.spacing(face);
  if (spacings > shortest) point.error.add_smooth(charts.expected_error(face), crossing.turn, spacings);
  if (target.vertex == no_index) return point;
  point.bend = bend_beyond(met, target, crossing);
  return point;
}

SurfacePoint FrontField::on_edge(const Met& met, double share) const {
  const int i = static_cast<int>(met.ray.half_edge % 3);
  SurfacePoint at{met.ray.half_edge / 3, {}};
  at.b[i] = curves_.forward(met.ray.half_edge) ? 1 - share : share, at.b[(i + 1) % 3] = 1 - at.b[i];
  return at;
}

double FrontField::bend_beyond(const Met& met, const FrontTarget& target, const Crossing& crossing) const {
  const EdgeCurve& curve = met.front.curve();
  const double share = std::clamp(crossing.share, 0.0, 1.0);
  double spread = crossing.spread;
  if (spread != spread)
    spread = ((1 - share) * points_[curve.from].bend + share * points_[curve.to].bend) /
             (crossing.distance - crossing.length);
  const SurfacePoint begin = on_edge(met, share);
  SurfacePoint middle{begin.face, {begin.b[0] / 2, begin.b[1] / 2, begin.b[2] / 2}};
  middle.b[(met.ray.half_edge + 2) % 3] += 0.5;  // of the corner beyond
  const double at_begin = curves_.curvature(begin), at_end = curves_.vertex(target.vertex).curvature;
  const double between = met.faces == 1 ? curves_.curvature(middle) : (at_begin + at_end) / 2;
  const Spread end = Spread{1, spread}.after(crossing.length, {at_begin, between, at_end});
  return end.apart > 0 ? crossing.distance * end.slope / end.apart : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace geodrome
