// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geodrome/detail/connectivity.hpp"
#include "geodrome/errors.hpp"
#include "geodrome/geometry.hpp"

namespace geodrome {

/// Three different vertex indices.
using Triangle = std::array<Index, 3>;

/// A point of a surface: a face and barycentric coordinates of its three corners (>= 0, sum 1).
struct SurfacePoint {
  Index face = no_index;
  std::array<double, 3> b{};

  friend constexpr bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

/// A triangle mesh: flat, immutable, shared by all threads. It may be non-manifold, unoriented, open, in several
/// components, and may have vertices that no face uses; a plugin's `needs` decides what it works on.
///
/// Half-edge 3 f + i runs from corner i of face f to corner i + 1. Lengths are in the units of the input.
class SurfaceMesh {
 public:
  /// `face_weights` is empty (all 1) or has one positive number per face. Throws InputError for an index out of range,
  /// a face that repeats a vertex, a coordinate or weight that is not finite. O(F log F).
  SurfaceMesh(std::vector<Vec3> positions, std::vector<Triangle> triangles, std::vector<double> face_weights = {})
      : positions_(std::move(positions)), triangles_(std::move(triangles)), face_weights_(std::move(face_weights)) {
    check();
    connectivity_ = detail::connect(triangles_, positions_.size());
  }

  /// The accessors below are O(1) and, as all members, thread-safe. What they point into lives as long as the mesh.
  std::size_t vertex_count() const noexcept { return positions_.size(); }
  std::size_t face_count() const noexcept { return triangles_.size(); }
  std::span<const Vec3> positions() const noexcept { return positions_; }
  std::span<const Triangle> triangles() const noexcept { return triangles_; }
  /// The cost of a unit of length, per face; empty if it is 1 everywhere.
  std::span<const double> face_weights() const noexcept { return face_weights_; }

  /// The half-edge on the other side of the edge, per half-edge; no_index on the boundary. On an unoriented surface
  /// both may run the same way. Empty if an edge has more than two faces.
  std::span<const Index> twins() const noexcept { return connectivity_.twins; }

  /// Every edge has at most two faces, and the faces around every vertex form one fan. Orientation does not matter.
  bool manifold() const noexcept { return connectivity_.manifold; }
  /// The two faces of every edge run along it in opposite directions.
  bool oriented() const noexcept { return connectivity_.oriented; }
  /// Every edge has at least two faces.
  bool closed() const noexcept { return connectivity_.closed; }

  /// The lowest half-edge that starts at a vertex; no_index if no face uses the vertex.
  Index first_half_edge(Index vertex) const { return connectivity_.first_half_edge[vertex]; }

  /// The face of a half-edge, the half-edges behind and before it in that face, the vertices where it starts and ends.
  static constexpr Index face(Index half_edge) { return half_edge / 3; }
  static constexpr Index next(Index half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
  static constexpr Index previous(Index half_edge) { return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1; }
  Index from(Index half_edge) const { return triangles_[half_edge / 3][half_edge % 3]; }
  Index to(Index half_edge) const { return from(next(half_edge)); }

  /// The corners of a face in space.
  std::array<Vec3, 3> corners(Index face) const {
    const Triangle& t = triangles_[face];
    return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
  }

  /// A surface point in space. Exact at corners.
  Vec3 position(const SurfacePoint& point) const {
    const auto [p, q, r] = corners(point.face);
    return point.b[0] * p + point.b[1] * q + point.b[2] * r;
  }

  /// A vertex as a surface point, on the face of its first half-edge. Throws InputError if no face uses the vertex.
  SurfacePoint at_vertex(Index vertex) const {
    const Index h = vertex < vertex_count() ? first_half_edge(vertex) : no_index;
    if (h == no_index) throw InputError(InputFault::index, "vertex " + std::to_string(vertex) + " is on no face");
    SurfacePoint point{h / 3, {}};
    point.b[h % 3] = 1;
    return point;
  }

  /// The vertex that a surface point coincides with (a coordinate equal to 1), or no_index.
  Index vertex_at(const SurfacePoint& point) const {
    for (int i = 0; i < 3; ++i)
      if (point.b[i] == 1) return triangles_[point.face][i];
    return no_index;
  }

  /// Memory held, in bytes.
  std::size_t bytes() const noexcept {
    return positions_.size() * (sizeof(Vec3) + sizeof(Index)) +
           triangles_.size() * (sizeof(Triangle) + 3 * sizeof(Index)) + face_weights_.size() * sizeof(double);
  }

 private:
  void check() const {
    const auto fail = [](InputFault fault, const char* what, std::size_t i) {
      throw InputError(fault, std::string(what) + " (element " + std::to_string(i) + ")");
    };
    if (positions_.size() >= no_index || triangles_.size() >= no_index / 3)
      fail(InputFault::unsupported, "mesh too large", 0);
    if (!face_weights_.empty() && face_weights_.size() != triangles_.size())
      fail(InputFault::index, "face weights do not match the faces", 0);
    for (std::size_t v = 0; v < positions_.size(); ++v)
      if (!is_finite(positions_[v])) fail(InputFault::nonfinite, "vertex is not finite", v);
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
      const auto& [a, b, c] = triangles_[f];
      if (std::max({a, b, c}) >= positions_.size()) fail(InputFault::index, "face names a vertex that is not there", f);
      if (a == b || b == c || c == a) fail(InputFault::degenerate, "face names a vertex twice", f);
    }
    for (std::size_t f = 0; f < face_weights_.size(); ++f)
      if (!(face_weights_[f] > 0) || !std::isfinite(face_weights_[f]))
        fail(InputFault::range, "face weight is not positive and finite", f);
  }

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
  std::vector<double> face_weights_;
  detail::Connectivity connectivity_;
};

/// A mesh as it is handed over: shared, never changed, kept alive by whoever holds it.
using MeshPtr = std::shared_ptr<const SurfaceMesh>;

}  // namespace geodrome
