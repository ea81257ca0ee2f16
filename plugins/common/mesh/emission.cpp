// SPDX-License-Identifier: MIT
#include "plugins/common/mesh/emission.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {
namespace {

/// Directions are widened by this angle (rad), which is more than the error of the direction of the path that came in.
/// A window too many costs little.
constexpr double margin = 1e-3;

Angle angle_at(const PackedMesh& surface, Index corner) {
  const PackedMesh::Face& face = surface.face_of(corner);
  return {face.cosine[corner % 3], face.sine[corner % 3]};
}

enum class Way { counterclockwise, clockwise };

/// Returns how many corners after position `at` (around a vertex) end before a half turn from where the path came in:
/// at most all others, and on the boundary those up to it. `turned` is the angle to the far side of the corner at `at`.
std::size_t corners_before_half_turn(const PackedMesh& surface, std::span<const Index> corners, std::size_t at,
                                     Angle turned, Way way, bool closed) {
  static const Angle widening{std::cos(margin), std::sin(margin)};
  const bool forward = way == Way::counterclockwise;
  const std::size_t count = corners.size(), others = closed ? count - 1 : forward ? count - 1 - at : at;
  // `turned` is below a half turn before a corner is added, and a corner has at most that.
  const auto reached = [&] {
    const Angle widened = turned + widening;
    return widened.sine < 0 || (widened.sine == 0 && widened.cosine < 0);
  };
  if (reached()) return 0;
  for (std::size_t passed = 0; passed < others; ++passed) {
    const std::size_t next = forward ? (at + 1 + passed) % count : (at + count - 1 - passed) % count;
    turned = turned + angle_at(surface, corners[next]);
    if (reached()) return passed;
  }
  return others;
}

}  // namespace

void corners_that_emit(const PackedMesh& surface, Index vertex, const Label& label, std::vector<Index>& out) {
  using Kind = PackedMesh::VertexKind;
  out.clear();
  const Kind kind = surface.kind(vertex);
  const auto corners = surface.corners(vertex);
  if (label.corner == no_index || label.all_sides() || kind == Kind::irregular) {
    out.assign(corners.begin(), corners.end());
    return;
  }
  if (kind == Kind::smooth) return;
  const bool closed = kind == Kind::saddle;
  const std::size_t count = corners.size();
  const std::size_t at = std::find(corners.begin(), corners.end(), label.corner) - corners.begin();
  const std::size_t before = corners_before_half_turn(
      surface, corners, at, angle_at(surface, label.corner) - label.side, Way::counterclockwise, closed);
  const std::size_t after = corners_before_half_turn(surface, corners, at, label.side, Way::clockwise, closed);
  if (closed) {
    for (std::size_t i = before; i + after + 1 < count; ++i) out.push_back(corners[(at + 1 + i) % count]);
  } else {
    for (std::size_t i = at + 1 + before; i < count; ++i) out.push_back(corners[i]);
    for (std::size_t i = 0; i + after < at; ++i) out.push_back(corners[i]);
  }
}

}  // namespace geodrome
