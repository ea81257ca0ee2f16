// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/surface/face_weight.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// The cost of the straight way between two points of one face: the length in space, from differences of coordinates so
/// that it is exact far from the origin too, times the face's weight.
inline double straight_within(const SurfaceMesh& mesh, Index face, const std::array<double, 3>& a,
                              const std::array<double, 3>& b) {
  const auto [p, q, r] = mesh.corners(face);
  return weight_of(mesh, face) * norm((a[1] - b[1]) * (q - p) + (a[2] - b[2]) * (r - p));
}

/// Which faces hold a surface point, and distances within them: what is needed to judge a polyline on a surface without
/// trusting the solver that made it. A point on an edge or at a vertex lies in all faces of that edge or vertex.
class CommonFace {
 public:
  /// O(V + F).
  explicit CommonFace(const SurfaceMesh& mesh) : mesh_(mesh), first_(mesh.vertex_count() + 1) {
    for (const Triangle& t : mesh.triangles())
      for (const Index v : t) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    faces_.resize(3 * mesh.face_count());
    std::vector<Index> end = first_;
    for (Index f = 0; f < mesh.face_count(); ++f)
      for (const Index v : mesh.triangles()[f]) faces_[end[v]++] = f;
  }

  /// `point` as coordinates on `face`, if that face holds it.
  std::optional<std::array<double, 3>> on_face(const SurfacePoint& point, Index face) const {
    if (point.face == face) return point.b;
    const Triangle &from = mesh_.triangles()[point.face], &to = mesh_.triangles()[face];
    std::array<double, 3> b{};
    for (int i = 0; i < 3; ++i) {
      if (point.b[i] == 0) continue;
      int j = 0;
      while (j < 3 && to[j] != from[i]) ++j;
      if (j == 3) return std::nullopt;
      b[j] = point.b[i];
    }
    return b;
  }

  /// Returns the point named on the next face that holds it; calling this again goes around all of them, back to where
  /// it began. Returns the point itself if it lies inside its face or on the border. O(degree).
  SurfacePoint on_next_face(const SurfacePoint& point) const {
    const auto corner = std::ranges::find_if(point.b, [](double b) { return b != 0; }) - point.b.begin();
    const std::span<const Index> faces = faces_at(mesh_.triangles()[point.face][corner]);
    const std::size_t own = std::ranges::find(faces, point.face) - faces.begin();
    for (std::size_t i = 1; i < faces.size(); ++i) {
      const Index face = faces[(own + i) % faces.size()];
      if (const auto b = on_face(point, face)) return {face, *b};
    }
    return point;
  }

  /// Calls `use` with each face that holds both points, in ascending order, and their coordinates there, until it
  /// returns false. O(the lowest degree of the corners that p depends on).
  template <class Use>
  void for_each_common(const SurfacePoint& p, const SurfacePoint& q, Use&& use) const {
    // A face that holds p holds each corner that p depends on: the one with the fewest faces is enough.
    std::span<const Index> faces;
    for (int i = 0; i < 3; ++i) {
      if (p.b[i] == 0) continue;
      const std::span<const Index> there = faces_at(mesh_.triangles()[p.face][i]);
      if (faces.empty() || there.size() < faces.size()) faces = there;
    }
    for (const Index face : faces) {
      const auto a = on_face(p, face), b = on_face(q, face);
      if (a && b && !use(face, *a, *b)) return;
    }
  }

  /// Returns the cost of the straight way between two points in the cheapest face that holds both: its length times the
  /// face's weight. Returns nothing if no face holds both. Complexity as above.
  std::optional<double> straight(const SurfacePoint& p, const SurfacePoint& q) const {
    std::optional<double> cheapest;
    for_each_common(p, q, [&](Index face, const std::array<double, 3>& a, const std::array<double, 3>& b) {
      const double cost = straight_within(mesh_, face, a, b);
      cheapest = std::min(cost, cheapest.value_or(cost));
      return !mesh_.face_weights().empty();  // without weights it is the same in every face
    });
    return cheapest;
  }

 private:
  std::span<const Index> faces_at(Index vertex) const {
    return {faces_.data() + first_[vertex], faces_.data() + first_[vertex + 1]};
  }

  const SurfaceMesh& mesh_;
  std::vector<Index> first_, faces_;
};

}  // namespace geodrome
