// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/edge_curves.hpp"

#include <cmath>
#include <numbers>

namespace geodrome {

namespace {

using Coefficients = std::array<double, EdgeCurve::size>;

/// Where curves are asked for: Chebyshev's places, at which a polynomial through them errs evenly; the ends among them.
std::array<double, EdgeCurve::size> places_on_edge() {
  std::array<double, EdgeCurve::size> at;
  for (int i = 0; i < EdgeCurve::size; ++i) at[i] = 0.5 - 0.5 * std::cos(std::numbers::pi * i / (EdgeCurve::size - 1));
  at.front() = 0, at.back() = 1;
  return at;
}

/// The polynomials that are 1 at one of the places and 0 at the others.
std::array<Coefficients, EdgeCurve::size> lagrange() {
  const auto at = places_on_edge();
  std::array<Coefficients, EdgeCurve::size> all{};
  for (int i = 0; i < EdgeCurve::size; ++i) {
    Coefficients& c = all[i];
    c[0] = 1;
    for (int j = 0; j < EdgeCurve::size; ++j) {
      if (j == i) continue;
      const double over = 1 / (at[i] - at[j]);
      for (int k = EdgeCurve::size - 1; k >= 0; --k) c[k] = over * ((k > 0 ? c[k - 1] : 0) - at[j] * c[k]);
    }
  }
  return all;
}

/// A place on a half-edge, asked along it.
SmoothPlace place_on(const SurfaceMesh& mesh, Index half_edge, double share) {
  const int i = half_edge % 3;
  const std::array<Vec3, 3> corners = mesh.corners(half_edge / 3);
  const Vec3 along = corners[(i + 1) % 3] - corners[i];
  SmoothPlace place{{half_edge / 3, {}}, along / norm(along)};
  place.at.b[i] = 1 - share, place.at.b[(i + 1) % 3] = share;
  return place;
}

/// The same place, asked across the half-edge.
SmoothPlace across(const SurfaceMesh& mesh, SmoothPlace place) {
  const auto [p, q, r] = mesh.corners(place.at.face);
  const Vec3 normal = cross(q - p, r - p);
  place.direction = cross(normal / norm(normal), place.direction);
  return place;
}

/// The surface above a place on a half-edge, with its derivatives along and across.
std::array<SmoothPoint, 2> two_ways(const SmoothCharts& charts, Index half_edge, double share) {
  std::array<SmoothPlace, 2> places;
  places[0] = place_on(charts.mesh(), half_edge, share), places[1] = across(charts.mesh(), places[0]);
  std::array<SmoothPoint, 2> points;
  charts.surface().evaluate(places, points);
  return points;
}

/// How the normal changes, from its changes along two directions.
std::array<Vec3, 3> turn_of(const SmoothPoint& d, const SmoothPoint& e) {
  const double dd = dot(d.velocity, d.velocity), de = dot(d.velocity, e.velocity), ee = dot(e.velocity, e.velocity);
  const double over = 1 / (dd * ee - de * de);
  const Vec3 to_d = over * (ee * d.velocity - de * e.velocity), to_e = over * (dd * e.velocity - de * d.velocity);
  const auto row = [&](double nd, double ne) { return nd * to_d + ne * to_e; };
  const std::array<Vec3, 3> m{row(d.normal_velocity.x, e.normal_velocity.x),
                              row(d.normal_velocity.y, e.normal_velocity.y),
                              row(d.normal_velocity.z, e.normal_velocity.z)};
  const double xy = 0.5 * (m[0].y + m[1].x), xz = 0.5 * (m[0].z + m[2].x), yz = 0.5 * (m[1].z + m[2].y);
  return {Vec3{m[0].x, xy, xz}, {xy, m[1].y, yz}, {xz, yz, m[2].z}};
}

/// The product of the two principal curvatures: of a symmetric matrix with an eigenvalue 0, the sum of its minors.
double curvature_of(const std::array<Vec3, 3>& m) {
  return m[0].x * m[1].y - m[0].y * m[1].x + m[0].x * m[2].z - m[0].z * m[2].x + m[1].y * m[2].z - m[1].z * m[2].y;
}

/// Where the surface is beside a point of it, by its tangent plane and how the normal turns, from its derivatives along
/// two directions. `by` and `upright` are orthogonal: the point is to be moved by `by`, as seen along `upright`.
SmoothPoint moved_by(const SmoothPoint& d, const SmoothPoint& e, const Vec3& by, const Vec3& upright) {
  const Vec3 move = by - dot(d.normal, by) / dot(d.normal, upright) * upright;
  const double dd = dot(d.velocity, d.velocity), de = dot(d.velocity, e.velocity), ee = dot(e.velocity, e.velocity);
  const double dm = dot(d.velocity, move), em = dot(e.velocity, move), over = 1 / (dd * ee - de * de);
  const Vec3 turn = over * ((dm * ee - em * de) * d.normal_velocity + (em * dd - dm * de) * e.normal_velocity);
  SmoothPoint result = d;
  result.position = d.position + move - 0.5 * dot(move, turn) * d.normal;
  result.normal = d.normal + turn;
  return result;
}

std::array<Vec3, 3> sum(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

}  // namespace

CurvePoint EdgeCurve::at(double t) const {
  CurvePoint p{position.back(), {}, {}, normal.back()};
  for (int k = size - 2; k >= 0; --k) {
    p.second = t * p.second + 2 * p.first;
    p.first = t * p.first + p.position;
    p.position = t * p.position + position[k];
    p.normal = t * p.normal + normal[k];
  }
  return p;
}

EdgeCurves::EdgeCurves(const SmoothCharts& charts) : charts_(charts) {
  index_edges();
  shape_vertices();
  trace_edges();
  bend_edges();
}

void EdgeCurves::index_edges() {
  const SurfaceMesh& mesh = charts_.mesh();
  edge_of_.resize(3 * mesh.face_count()), first_.resize(mesh.vertex_count() + 1);
  for (Index h = 0; h < edge_of_.size(); ++h) {
    ++first_[mesh.from(h) + 1];
    const Index twin = mesh.twins()[h];
    const bool trusted = charts_.trusts(h / 3) && (twin == no_index || charts_.trusts(twin / 3));
    if (twin < h) {
      edge_of_[h] = edge_of_[twin];
    } else {
      edge_of_[h] = static_cast<Index>(edges_.size());
      edges_.push_back({.from = mesh.from(h), .to = mesh.to(h), .trusted = trusted});
    }
  }
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<Index> end = first_;
  around_.resize(edge_of_.size());
  for (Index h = 0; h < edge_of_.size(); ++h) around_[end[mesh.from(h)]++] = h;
}

/// Blends above an edge run beside it a little, by the square of how its two corners' normals differ, and unevenly. A
/// distance is a smooth function of the edge's share only if the curve is: it is moved, on the surface, into the plane
/// through the edge's ends and `upright`.
void EdgeCurves::trace_edge(Index h, EdgeCurve& curve) const {
  static const auto at = places_on_edge();
  static const auto basis = lagrange();
  const Vec3 &begin = vertices_[curve.from].position, side = vertices_[curve.to].position - begin;
  Vec3 upright = vertices_[curve.from].normal + vertices_[curve.to].normal;
  upright = upright - dot(upright, side) / squared_norm(side) * side, upright = upright / norm(upright);
  curve.length = norm(side);
  std::array<SmoothPlace, 2 * EdgeCurve::size> places;
  std::array<SmoothPoint, 2 * EdgeCurve::size> points;
  for (int i = 0; i < EdgeCurve::size; ++i) {
    places[2 * i] = place_on(mesh(), h, forward(h) ? at[i] : 1 - at[i]);
    places[2 * i + 1] = across(mesh(), places[2 * i]);
  }
  charts_.surface().evaluate(places, points);
  const double share = mesh().twins()[h] == no_index ? 1 : 0.5;
  for (int i = 0; i < EdgeCurve::size; ++i) {
    const Vec3 aside = points[2 * i].position - begin - at[i] * side;
    const SmoothPoint point =
        moved_by(points[2 * i], points[2 * i + 1], dot(aside, upright) * upright - aside, upright);
    for (int k = 0; k < EdgeCurve::size; ++k) {
      curve.position[k] = curve.position[k] + share * basis[i][k] * point.position;
      curve.normal[k] = curve.normal[k] + share * basis[i][k] * point.normal;
    }
  }
}

void EdgeCurves::trace_edges() {
  for (Index h = 0; h < edge_of_.size(); ++h)
    if (edges_[edge_of_[h]].trusted) trace_edge(h, edges_[edge_of_[h]]);
}

void EdgeCurves::shape_vertices() {
  vertices_.resize(mesh().vertex_count());
  for (Index v = 0; v < vertices_.size(); ++v) {
    VertexShape& vertex = vertices_[v];
    vertex.position = mesh().positions()[v];
    double faces = 0;
    for (const Index h : starting_at(v)) {
      if (!charts_.trusts(h / 3)) continue;
      const std::array<SmoothPoint, 2> points = two_ways(charts_, h, 0);
      vertex.position = points[0].position, vertex.normal = vertex.normal + points[0].normal;
      vertex.turn = sum(vertex.turn, turn_of(points[0], points[1]));
      ++faces;
    }
    if (faces == 0) continue;
    vertex.normal = vertex.normal / norm(vertex.normal);
    for (Vec3& row : vertex.turn) row = row / faces;
    vertex.curvature = curvature_of(vertex.turn);
  }
}

void EdgeCurves::bend_edges() {
  curvature_.resize(edges_.size());
  for (Index h = 0; h < edge_of_.size(); ++h) {
    if (!charts_.trusts(h / 3)) continue;
    const std::array<SmoothPoint, 2> points = two_ways(charts_, h, 0.5);
    const Index twin = mesh().twins()[h];
    const double share = twin == no_index || !charts_.trusts(twin / 3) ? 1 : 0.5;
    curvature_[edge_of_[h]] += share * curvature_of(turn_of(points[0], points[1]));
  }
}

double EdgeCurves::curvature(const SurfacePoint& at) const {
  double k = 0;
  for (int i = 0; i < 3; ++i) {
    const Index h = 3 * at.face + i;
    const double b = at.b[i], next = at.b[(i + 1) % 3];
    k += b * (2 * b - 1) * vertices_[mesh().from(h)].curvature + 4 * b * next * curvature_[edge_of_[h]];
  }
  return k;
}

}  // namespace geodrome
