// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "geodrome/solver_kit/packed_mesh.hpp"

namespace geodrome {

struct Place {
  double x, y;
};
inline Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
inline double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
inline double cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
inline double length(const Place& a) { return std::hypot(a.x, a.y); }

/// A corner of a triangle in the plane of the face that is split.
struct PlacedVertex {
  Index vertex;
  Place at;
};

/// A face seen from corner i: that corner at the origin, the next one on the x axis, the last one at y >= 0.
struct SeenFace {
  PlacedVertex right, left;
  SeenFace(const PackedMesh::Face& face, int i)
      : right{face.vertex[(i + 1) % 3], {face.length[i], 0}},
        left{face.vertex[(i + 2) % 3],
             {face.length[(i + 2) % 3] * face.cosine[i], face.length[(i + 2) % 3] * face.sine[i]}} {}
};

/// Splits an obtuse corner of a face by unfolding (Kimmel and Sethian 1998, Section 4.2): the faces behind the opposite
/// edge are laid out one by one, always across the edge that leaves the cone in which a line from the corner makes
/// no obtuse angle with either side, until a vertex lies in the cone. The line to it runs inside the strip, since the
/// ends of every edge that was crossed lie on both sides of the cone. Nothing if the boundary or an edge of more than
/// two faces comes first, or no vertex within `most_unfolded` faces.
class ObtuseSplit {
 public:
  static constexpr int most_unfolded = 64;

  /// The angle at corner `i` of `face` must be above pi / 2, and below pi.
  static std::optional<PlacedVertex> find(const PackedMesh& surface, Index face, int i) {
    ObtuseSplit split(surface, face, i);
    for (int n = 0; n < most_unfolded && split.unfold(); ++n)
      if (split.found_) return split.found_;
    return std::nullopt;
  }

 private:
  ObtuseSplit(const PackedMesh& surface, Index face, int i)
      : surface_(surface), seen_(surface.face(face), i), right_(seen_.right.at), left_(seen_.left.at) {
    edge_ = 3 * face + static_cast<Index>((i + 1) % 3);
  }

  /// Lays out the face across the present edge. False if there is not exactly one, or it leads nowhere.
  bool unfold() {
    const Place edge = left_ - right_;
    const double size = length(edge);
    if (surface_.is_fan(edge_) || !(size > 0)) return false;
    Index other = no_index;
    surface_.for_each_across(edge_, [&](Index h, bool mirrored) {
      other = h;
      from_right_ = mirrored ? from_right_ : !from_right_;
    });
    if (other == no_index) return false;
    const int k = static_cast<int>(other % 3);
    const auto [x, y] = PackedMesh::apex(surface_.face_of(other), k);
    const Place ahead{edge.x / size, edge.y / size}, away{ahead.y, -ahead.x};
    const double along = from_right_ ? x : size - x;
    const Place apex{right_.x + along * ahead.x + y * away.x, right_.y + along * ahead.y + y * away.y};
    return advance(other, {surface_.face_of(other).vertex[(k + 2) % 3], apex});
  }

  /// The apex splits the corner, or replaces the end of the edge on its side of the cone.
  bool advance(Index crossed, const PlacedVertex& apex) {
    const bool not_left = dot(apex.at, seen_.right.at) >= 0, not_right = dot(apex.at, seen_.left.at) >= 0;
    if (not_left && not_right) {
      found_ = apex;
      return true;
    }
    if (!not_left && !not_right) return false;
    (not_left ? right_ : left_) = apex.at;
    // Of the two other half-edges of the face the first starts at the crossed one's end, the second ends at its start.
    const bool first = not_left == from_right_;
    edge_ = first ? SurfaceMesh::next(crossed) : SurfaceMesh::previous(crossed);
    from_right_ = first != not_left;
    return true;
  }

  const PackedMesh& surface_;
  SeenFace seen_;
  Place right_, left_;      // the ends of the present edge
  Index edge_;              // as a half-edge of the face laid out last
  bool from_right_ = true;  // it starts at the right end
  std::optional<PlacedVertex> found_;
};

}  // namespace geodrome
