// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <tuple>

#include "common/solvers/flat_surface.hpp"
#include "solver_chen_han/bisector.hpp"
#include "solver_chen_han/labels.hpp"
#include "solver_chen_han/lanes.hpp"
#include "solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// A face seen from one of its half-edges: start A, end B, the third corner C, its apex, at (x, y). Windows enter
/// through the half-edge and leave through the edge from C to A on their left or that from B to C on their right.
struct Apex {
  Index half_edge;
  const FlatSurface::Face& face;
  int a, b, c;  ///< corners of the face
  double length, x, y;

  Apex(const FlatSurface& surface, Index h)
      : half_edge(h), face(surface.face_of(h)), a(h % 3), b((a + 1) % 3), c((a + 2) % 3), length(face.length[a]) {
    std::tie(x, y) = FlatSurface::apex(face, a);
  }
  Index start() const { return face.vertex[a]; }
  Index end() const { return face.vertex[b]; }
  Index vertex() const { return face.vertex[c]; }
  Index left() const { return SurfaceMesh::previous(half_edge); }
  Index right() const { return SurfaceMesh::next(half_edge); }
  double left_length() const { return face.length[c]; }
  double right_length() const { return face.length[b]; }
  bool left_is_boundary() const { return face.across[c] == no_index; }
  bool right_is_boundary() const { return face.across[b] == no_index; }
  Angle angle(int corner) const { return {face.cosine[corner], face.sine[corner]}; }

  /// How windows pass to the frame of the half-edge beyond the left or right edge.
  Turn turn_left() const { return {0, face.cosine[a], face.sine[a], 0, left_length(), left_length()}; }
  Turn turn_right() const { return {length, face.cosine[b], -face.sine[b], right_length(), right_length(), 0}; }

  /// Whether window i has lines to the left or right of the apex.
  bool has_left(const WindowArrays& w, std::size_t i) const { return side_of_line(w.x[i], w.y[i], w.low[i], x, y) < 0; }
  bool has_right(const WindowArrays& w, std::size_t i) const {
    return side_of_line(w.x[i], w.y[i], w.high[i], x, y) > 0;
  }
};

/// How an ordered list meets the apex: windows [0, left_end) have lines to its left, [right_begin, end) to its right;
/// what is in both has lines to it. `best` of those is nearest to it; from [first_best, last_best), which are as near
/// up to rounding, lines go on to both sides, from the others only to their own: one angle, one split.
struct Split {
  std::size_t right_begin, left_end, best, first_best, last_best;

  bool covered() const { return right_begin < left_end; }
  /// The windows [0, last_left) go on to the left, [first_right, end) to the right.
  std::size_t last_left() const { return covered() ? last_best : left_end; }
  std::size_t first_right() const { return covered() ? first_best : right_begin; }
};

/// The split of a list in order.
inline Split split_at(const Apex& apex, const WindowArrays& w, const Parting& parting) {
  Split split{parting.right_begin, parting.left_end, parting.right_begin, 0, 0};
  const auto distance = [&](std::size_t i) { return w.to(i, apex.x, apex.y); };
  for (std::size_t i = split.right_begin + 1; i < split.left_end; ++i)
    if (distance(i) < distance(split.best)) split.best = i;
  split.first_best = split.best, split.last_best = split.best + 1;
  if (split.left_end - split.right_begin > 1 && split.covered()) {
    const double most = distance(split.best) * (1 + equal_share);
    while (split.first_best > split.right_begin && distance(split.first_best - 1) <= most) --split.first_best;
    while (split.last_best < split.left_end && distance(split.last_best) <= most) ++split.last_best;
  }
  return split;
}

}  // namespace geodrome::chen_han
