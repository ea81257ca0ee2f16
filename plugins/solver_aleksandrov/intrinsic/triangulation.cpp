// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::aleksandrov {

IntrinsicTriangulation::IntrinsicTriangulation(const PackedMesh& surface, double tiny)
    : vertex_count_(static_cast<Index>(surface.vertex_count())), past_(static_cast<Index>(surface.face_count())) {
  const auto faces = static_cast<Index>(surface.face_count());
  faces_.reserve(faces);
  for (Index f = 0; f < faces; ++f) {
    const PackedMesh::Face& from = surface.face(f);
    Face& face = faces_.emplace_back();
    for (int i = 0; i < 3; ++i) {
      face.vertex[i] = from.vertex[i], face.length[i] = from.length[i];
      face.cosine[i] = from.cosine[i], face.sine[i] = from.sine[i];
    }
    triangle_of_face_.push_back(f), face_of_triangle_.push_back(f);
  }
  const auto weights = surface.mesh().face_weights();
  for (Index f = 0; f < faces && !weights.empty(); ++f) weights_.push_back(weights[surface.original_face(f)]);
  connect(surface);
  lengthen(tiny);
}

/// Rings in ascending order, ways as those of the lowest half-edge.
void IntrinsicTriangulation::connect(const PackedMesh& surface) {
  next_on_edge_.resize(3 * faces_.size());
  forward_.assign(3 * faces_.size(), true);
  std::vector<std::pair<Index, bool>> ring;
  for (Index h = 0; h < next_on_edge_.size(); ++h) {
    ring.assign(1, {h, true});
    bool lowest = true;
    surface.for_each_across(h, [&](Index other, bool mirrored) {
      ring.emplace_back(other, mirrored);
      lowest = lowest && h < other;
    });
    if (!lowest) continue;
    std::sort(ring.begin(), ring.end());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      next_on_edge_[ring[i].first] = ring[(i + 1) % ring.size()].first;
      forward_[ring[i].first] = ring[i].second;
    }
  }
}

/// Faces with edges that have no length become very thin ones.
void IntrinsicTriangulation::lengthen(double tiny) {
  for (Face& face : faces_) {
    double& shortest = *std::min_element(face.length, face.length + 3);
    if (shortest > 0) continue;
    for (double& side : face.length) side = std::max(side, tiny);
    const int k = static_cast<int>(&shortest - face.length), apex = (k + 2) % 3;
    // The sides beside it are equally long: vertices at one place have the same distance from the third.
    const double half = std::min(0.5, 0.5 * tiny / face.length[(k + 1) % 3]), high = std::sqrt(1 - half * half);
    face.cosine[apex] = 1 - 2 * half * half, face.sine[apex] = 2 * half * high;
    for (const int i : {k, (k + 1) % 3}) face.cosine[i] = half, face.sine[i] = high;
  }
}

Point2 IntrinsicTriangulation::apex(Index h) const {
  const Face& face = faces_[h / 3];
  const double side = face.length[(h + 2) % 3];
  return {side * face.cosine[h % 3], side * face.sine[h % 3]};
}

Point2 IntrinsicTriangulation::in_next_frame(Index h, Point2 p) const {
  const Face& face = faces_[h / 3];
  const int i = static_cast<int>(h % 3), j = (i + 1) % 3;
  const Point2 along{-face.cosine[j], face.sine[j]}, q{p.x - face.length[i], p.y};
  return {dot(along, q), cross(along, q)};
}

Index IntrinsicTriangulation::flat_twin(Index h) const {
  const Index g = next_on_edge_[h];
  const bool flat =
      g != h && next_on_edge_[g] == h && g / 3 != h / 3 && !same_way(g, h) && weight(g / 3) == weight(h / 3);
  return flat ? g : no_index;
}

/// Sides that were there before must keep their length to the last bit, so callers put those back.
void IntrinsicTriangulation::lay_out(Index f, const std::array<Index, 3>& vertex, const Triangle2& corners) {
  Face& face = faces_[f];
  face.vertex = vertex;
  for (int i = 0; i < 3; ++i) {
    const Point2 along = corners[(i + 1) % 3] - corners[i], back = corners[(i + 2) % 3] - corners[i];
    const double x = dot(along, back), y = std::max(0.0, cross(along, back)), size = std::hypot(x, y);
    face.length[i] = aleksandrov::length(along);
    face.cosine[i] = size > 0 ? x / size : 0, face.sine[i] = size > 0 ? y / size : 1;
  }
}

void IntrinsicTriangulation::join(Index g, Index h) {
  next_on_edge_[g] = h, next_on_edge_[h] = g;
  forward_[g] = true, forward_[h] = false;
}

template <std::size_t n>
void IntrinsicTriangulation::rename(const std::array<std::pair<Index, Index>, n>& renamed) {
  const auto name = [&](Index h) {
    for (const auto& [from, to] : renamed)
      if (from == h) return to;
    return h;
  };
  std::vector<Ring> rings;
  for (const auto& [start, to] : renamed) {
    Index h = start;
    do rings.push_back({h, next_on_edge_[h], static_cast<bool>(forward_[h])});
    while ((h = next_on_edge_[h]) != start);
  }
  for (const auto& [h, next, forward] : rings) next_on_edge_[name(h)] = name(next), forward_[name(h)] = forward;
}

Index IntrinsicTriangulation::add_face(Index like) {
  const Index f = face_count();
  faces_.emplace_back();
  if (weighted()) weights_.push_back(weights_[like]);
  next_on_edge_.resize(3 * faces_.size());
  forward_.resize(3 * faces_.size());
  triangle_of_face_.push_back(no_index);
  return f;
}

void IntrinsicTriangulation::record(const Rearrangement& change, std::initializer_list<Index> faces) {
  Index triangle = past_.add(change);
  for (const Index f : faces) triangle_of_face_[f] = triangle++, face_of_triangle_.push_back(f);
}

void IntrinsicTriangulation::flip(Index h) {
  const Index g = flat_twin(h), f = h / 3, k = g / 3;
  const Index right = SurfaceMesh::next(h), left = SurfaceMesh::previous(h);          // b -> c, c -> a
  const Index low_left = SurfaceMesh::next(g), low_right = SurfaceMesh::previous(g);  // a -> d, d -> b
  const double ends[4] = {length(left), length(low_left), length(low_right), length(right)};
  const Index a = from(h), b = from(g), c = from(left), d = from(low_right);
  const Point2 top = apex(h), below = apex(g);
  Rearrangement change;
  change.points = {Point2{0, 0}, Point2{length(h), 0}, top, Point2{length(h) - below.x, -below.y}};
  const auto corners = [](Index edge, std::array<std::uint8_t, 3> points) {
    std::array<std::uint8_t, 3> at{};
    for (Index i = 0; i < 3; ++i) at[(edge + i) % 3] = points[i];
    return at;
  };
  change.before = {{{triangle_of_face_[f], corners(h, {0, 1, 2})}, {triangle_of_face_[k], corners(g, {1, 0, 3})}}};
  change.after[0] = {0, {3, 2, 0}}, change.after[1] = {0, {2, 3, 1}};
  rename<4>({{{left, 3 * f + 1}, {low_left, 3 * f + 2}, {low_right, 3 * k + 1}, {right, 3 * k + 2}}});
  const auto& p = change.points;
  lay_out(f, {d, c, a}, {p[3], p[2], p[0]});
  lay_out(k, {c, d, b}, {p[2], p[3], p[1]});
  faces_[f].length[1] = ends[0], faces_[f].length[2] = ends[1];
  faces_[k].length[1] = ends[2], faces_[k].length[2] = ends[3];
  join(3 * f, 3 * k);
  record(change, {f, k});
}

Index IntrinsicTriangulation::split_face(Index h, Point2 p) {
  const Index f = h / 3, second = SurfaceMesh::next(h), third = SurfaceMesh::previous(h);
  const Index a = from(h), b = from(second), c = from(third), m = vertex_count_++;
  const double sides[3] = {length(h), length(second), length(third)};
  Rearrangement change;
  change.points = {Point2{0, 0}, Point2{sides[0], 0}, apex(h), p};
  auto& before = change.before[0];
  before.triangle = triangle_of_face_[f];
  for (Index i = 0; i < 3; ++i) before.corner[(h + i) % 3] = static_cast<std::uint8_t>(i);
  change.after = {{{0, {0, 1, 3}}, {0, {1, 2, 3}}, {0, {2, 0, 3}}}};
  const Index n = add_face(f), o = add_face(f);
  rename<3>({{{h, 3 * f}, {second, 3 * n}, {third, 3 * o}}});
  const auto& at = change.points;
  lay_out(f, {a, b, m}, {at[0], at[1], p});
  lay_out(n, {b, c, m}, {at[1], at[2], p});
  lay_out(o, {c, a, m}, {at[2], at[0], p});
  faces_[f].length[0] = sides[0], faces_[n].length[0] = sides[1], faces_[o].length[0] = sides[2];
  join(3 * f + 1, 3 * n + 2), join(3 * n + 1, 3 * o + 2), join(3 * o + 1, 3 * f + 2);
  record(change, {f, n, o});
  return m;
}

Index IntrinsicTriangulation::split_edge(Index h, double x) {
  std::vector<Index> ring{h};
  for (Index g = next_on_edge_[h]; g != h; g = next_on_edge_[g]) ring.push_back(g);
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (ring[i] / 3 == ring[j] / 3) return no_index;
  const bool way = forward_[h];
  const double whole = length(h);
  const Index m = vertex_count_++;
  std::vector<std::pair<Index, bool>> start, end;  // half-edges of the two parts, and their ways
  for (const Index g : ring) {
    const bool forward = forward_[g], same = forward == way;
    const Index f = g / 3, second = SurfaceMesh::next(g), third = SurfaceMesh::previous(g);
    const Index a = from(g), b = from(second), c = from(third);
    const double at = same ? x : whole - x, sides[2] = {length(second), length(third)};
    Rearrangement change;
    change.points = {Point2{0, 0}, Point2{whole, 0}, apex(g), Point2{at, 0}};
    auto& before = change.before[0];
    before.triangle = triangle_of_face_[f];
    for (Index i = 0; i < 3; ++i) before.corner[(g + i) % 3] = static_cast<std::uint8_t>(i);
    change.after[0] = {0, {0, 3, 2}}, change.after[1] = {0, {3, 1, 2}};
    const Index n = add_face(f);
    rename<2>({{{third, 3 * f + 2}, {second, 3 * n + 1}}});
    const auto& p = change.points;
    lay_out(f, {a, m, c}, {p[0], p[3], p[2]});
    lay_out(n, {m, b, c}, {p[3], p[1], p[2]});
    faces_[f].length[0] = at, faces_[n].length[0] = same ? whole - x : x;
    faces_[n].length[1] = sides[0], faces_[f].length[2] = sides[1];
    join(3 * f + 1, 3 * n + 2);
    record(change, {f, n});
    start.emplace_back(same ? 3 * f : 3 * n, forward), end.emplace_back(same ? 3 * n : 3 * f, forward);
  }
  for (const auto* part : {&start, &end})
    for (std::size_t i = 0; i < part->size(); ++i) {
      next_on_edge_[(*part)[i].first] = (*part)[(i + 1) % part->size()].first;
      forward_[(*part)[i].first] = (*part)[i].second;
    }
  return m;
}

SurfacePoint IntrinsicTriangulation::located(const SurfacePoint& flat) const {
  const Place place = past_.locate({flat.face, flat.b});
  return {face_of_triangle_[place.triangle], place.b};
}

void IntrinsicTriangulation::restore(Index f, const Barycentric& from, const Barycentric& to,
                                     std::vector<Piece>& out) const {
  past_.restore({triangle_of_face_[f], from, to}, out);
}

double to_opposite_side(const IntrinsicTriangulation::Face& face, int i) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  if (face.cosine[j] >= 0 && face.cosine[k] >= 0) return face.length[i] * face.sine[j];
  return std::min(face.length[i], face.length[k]);
}

std::size_t IntrinsicTriangulation::bytes() const {
  return faces_.size() * (sizeof(Face) + 3 * sizeof(Index) + 1) + weights_.size() * sizeof(double) +
         (triangle_of_face_.size() + face_of_triangle_.size()) * sizeof(Index) + past_.bytes();
}

}  // namespace geodrome::aleksandrov
