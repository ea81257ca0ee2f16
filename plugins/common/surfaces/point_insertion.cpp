// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/point_insertion.hpp"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <algorithm>

namespace geodrome {
namespace {

using OpenMesh::FaceHandle, OpenMesh::HalfedgeHandle, OpenMesh::VertexHandle;

/// A point this close to an edge, as a share of the face's height over it, lies on it: a triangle that thin has no
/// normal worth the name in double precision, and moving a point by that much moves no distance that anybody measures.
constexpr double on_edge = 1e-9;

/// A triangle whose height is below this share of its longest edge is refused, for the same reason.
constexpr double degenerate = 1e-9;

/// Triangles that are turned by more than 60 degrees against the face they replace do not approximate the same surface.
constexpr double least_cosine = 0.5;

/// A point farther from a face's plane than this share of its circumradius sees it across a crease, which a flip would
/// cut off. On a smooth sample the share is of the order of epsilon.
constexpr double crease = 0.25;

/// Distances of the point and of the corners from the centre of a sphere that differ by this share, which is rounding,
/// are a tie: the face stays, so that lattices come out the same everywhere.
constexpr double tie = 1e-12;

Vec3 normal(const Vec3& p, const Vec3& q, const Vec3& r) { return cross(q - p, r - p); }

Vec3 normal(const SurfaceMesh& mesh, Index face) {
  const auto [p, q, r] = mesh.corners(face);
  return normal(p, q, r);
}

/// Tells whether a triangle may take the place of a face with normal `like`.
bool fits(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& like) {
  const Vec3 own = normal(p, q, r);
  const double longest2 = std::max({squared_distance(p, q), squared_distance(q, r), squared_distance(r, p)});
  return norm(own) > degenerate * longest2 && dot(own, like) >= least_cosine * norm(own) * norm(like);
}

/// Tells whether the smallest sphere through the corners of a face holds the point.
bool sphere_holds(const SurfaceMesh& mesh, Index face, const Vec3& point) {
  const auto [p, q, r] = mesh.corners(face);
  const Vec3 u = q - p, v = r - p, n = cross(u, v), d = point - p;
  const double n2 = squared_norm(n);
  if (n2 == 0) return false;
  const Vec3 centre = cross(squared_norm(u) * v - squared_norm(v) * u, n) / (2 * n2);  // from p
  return 2 * dot(d, centre) - squared_norm(d) > tie * squared_norm(centre);
}

/// Returns the half-edge that a surface point lies on; no_index inside a face and at a vertex.
Index edge_of(const SurfacePoint& at) {
  Index edge = no_index;
  for (Index i = 0; i < 3; ++i) {
    if (at.b[i] > on_edge) continue;
    if (edge != no_index) return no_index;
    edge = 3 * at.face + (i + 1) % 3;
  }
  return edge;
}

/// Returns the corner of its face, 0 to 2, that a surface point lies at; 3 if at none.
Index corner_of(const SurfacePoint& at) {
  Index i = 0;
  while (i < 3 && at.b[i] < 1 - 2 * on_edge) ++i;
  return i;
}

/// Lists the boundary half-edges that a surface point lies on: one inside an edge, two at a vertex, mostly none.
std::vector<Index> boundary_at(const SurfaceMesh& mesh, const SurfacePoint& at) {
  const auto twin = [&](Index h) { return mesh.twins()[h]; };
  if (const Index edge = edge_of(at); edge != no_index)
    return twin(edge) == no_index ? std::vector{edge} : std::vector<Index>{};
  const Index corner = corner_of(at);
  if (corner == 3) return {};
  const Index begin = 3 * at.face + corner;
  Index out = begin, in = SurfaceMesh::previous(begin);
  while (twin(out) != no_index) {  // clockwise to the half-edge that leaves along the boundary
    out = SurfaceMesh::next(twin(out));
    if (out == begin) return {};
  }
  while (twin(in) != no_index) in = SurfaceMesh::previous(twin(in));
  return {out, in};
}

/// Returns the boundary half-edge that a point lies beyond, so that a triangle over it continues the surface: of two,
/// the one that it lies farther beyond; no_index if there is none.
Index edge_to_extend(const SurfaceMesh& mesh, const Vec3& point, const SurfacePoint& closest) {
  Index best = no_index;
  double farthest = 0;
  for (const Index h : boundary_at(mesh, closest)) {
    const Vec3 from = mesh.positions()[mesh.from(h)], to = mesh.positions()[mesh.to(h)];
    const Vec3 up = normal(mesh, SurfaceMesh::face(h)), outwards = cross(to - from, up);
    const double beyond = dot(point - from, outwards) / norm(outwards);
    if (beyond > farthest && fits(to, from, point, up)) best = h, farthest = beyond;
  }
  return best;
}

/// The faces around the point, as an OpenMesh mesh to be edited.
class Patch {
 public:
  /// Starts with the face `first`, and `second`, another one, or no_index.
  Patch(const SurfaceMesh& mesh, const Vec3& point, Index first, Index second) : mesh_(mesh), point_(point) {
    add(first);
    if (second != no_index) add(second);
    grow();
    for (const Index face : faces_) {
      const Triangle& t = mesh_.triangles()[face];
      links_.add_face(handle_of(t[0]), handle_of(t[1]), handle_of(t[2]));
    }
    star_ = links_.add_vertex();
    vertices_.push_back(static_cast<Index>(mesh_.vertex_count()));
  }

  void split_face() { links_.split(FaceHandle(0), star_); }
  void split_edge(Index h) { links_.split(links_.edge_handle(find(h)), star_); }
  void extend(Index h) { links_.add_face(handle_of(mesh_.to(h)), handle_of(mesh_.from(h)), star_); }

  /// Flips every edge that must be flipped. Returns true if no flip had to be refused.
  bool flip_edges() {
    bool all = true;
    std::vector<HalfedgeHandle> suspects;  // in faces of the star, opposite to the point
    for (const HalfedgeHandle h : links_.voh_range(star_))
      if (!links_.is_boundary(h)) suspects.push_back(links_.next_halfedge_handle(h));
    while (!suspects.empty()) {
      const HalfedgeHandle inner = suspects.back(), outer = links_.opposite_halfedge_handle(inner);
      suspects.pop_back();
      if (links_.is_boundary(outer) || !holds_[links_.face_handle(outer).idx()]) continue;
      if (!may_flip(inner, outer)) {
        all = false;
        continue;
      }
      const HalfedgeHandle one = links_.next_halfedge_handle(outer), other = links_.next_halfedge_handle(one);
      links_.flip(links_.edge_handle(inner));
      suspects.push_back(one), suspects.push_back(other);
    }
    return all;
  }

  LocalChange change(Insertion how) const {
    LocalChange change{{}, std::vector<Triangle>(links_.n_faces() - faces_.size()), how};
    for (const HalfedgeHandle h : links_.voh_range(star_)) {
      if (links_.is_boundary(h)) continue;
      const HalfedgeHandle opposite = links_.next_halfedge_handle(h);
      const Triangle corners{vertex(links_.from_vertex_handle(opposite)), vertex(links_.to_vertex_handle(opposite)),
                             vertices_.back()};
      const auto face = static_cast<std::size_t>(links_.face_handle(h).idx());
      if (face < faces_.size())
        change.replaced.emplace_back(faces_[face], corners);
      else
        change.added[face - faces_.size()] = corners;
    }
    std::sort(change.replaced.begin(), change.replaced.end());
    return change;
  }

 private:
  void add(Index face) {
    faces_.push_back(face);
    holds_.push_back(sphere_holds(mesh_, face, point_));
  }

  /// Adds the faces connected with the first ones whose spheres hold the point.
  void grow() {
    for (std::size_t k = 0; k < faces_.size(); ++k)
      for (Index i = 0; i < 3; ++i) {
        const Index twin = mesh_.twins()[3 * faces_[k] + i];
        if (twin == no_index || std::ranges::find(faces_, twin / 3) != faces_.end()) continue;
        if (sphere_holds(mesh_, twin / 3, point_)) add(twin / 3);
      }
  }

  VertexHandle handle_of(Index vertex) {
    const auto found = std::ranges::find(vertices_, vertex);
    if (found != vertices_.end()) return VertexHandle(static_cast<int>(found - vertices_.begin()));
    vertices_.push_back(vertex);
    return links_.add_vertex();
  }

  HalfedgeHandle find(Index h) { return links_.find_halfedge(handle_of(mesh_.from(h)), handle_of(mesh_.to(h))); }
  Index vertex(VertexHandle v) const { return vertices_[static_cast<std::size_t>(v.idx())]; }
  const Vec3& position(VertexHandle v) const { return mesh_.positions()[vertex(v)]; }

  bool may_flip(HalfedgeHandle inner, HalfedgeHandle outer) const {
    if (!links_.is_flip_ok(links_.edge_handle(inner))) return false;
    const Vec3 &a = position(links_.from_vertex_handle(inner)), &b = position(links_.to_vertex_handle(inner)),
               &c = position(links_.opposite_vh(outer));
    const Vec3 like = normal(b, a, c);
    const double radius = distance(a, b) * distance(b, c) * distance(c, a) / (2 * norm(like));
    if (std::abs(dot(point_ - a, like)) > crease * radius * norm(like)) return false;
    return fits(a, c, point_, like) && fits(c, b, point_, like);
  }

  const SurfaceMesh& mesh_;
  const Vec3 point_;
  OpenMesh::TriConnectivity links_;  // face k of it is faces_[k] until it becomes one of the star
  std::vector<Index> faces_, vertices_;
  std::vector<bool> holds_;
  VertexHandle star_;
};

}  // namespace

LocalChange insert_point(const SurfaceMesh& mesh, const Vec3& point, const SurfacePoint& closest) {
  if (const Index h = edge_to_extend(mesh, point, closest); h != no_index) {
    Patch patch(mesh, point, SurfaceMesh::face(h), no_index);
    patch.extend(h);
    patch.flip_edges();
    return patch.change(Insertion::extended);
  }
  const Index edge = edge_of(closest), twin = edge == no_index ? no_index : mesh.twins()[edge];
  Patch patch(mesh, point, closest.face, twin == no_index ? no_index : SurfaceMesh::face(twin));
  edge == no_index ? patch.split_face() : patch.split_edge(edge);
  return patch.change(patch.flip_edges() ? Insertion::cavity : Insertion::partial);
}

}  // namespace geodrome
