// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/intrinsic/rearrangements.hpp"

namespace geodrome::aleksandrov {
namespace {

Triangle2 layout_of(const Rearrangement& change, const Rearrangement::Piece& piece) {
  return {change.points[piece.corner[0]], change.points[piece.corner[1]], change.points[piece.corner[2]]};
}

int corner_at(const Rearrangement::Piece& piece, int point) {
  for (int i = 0; i < 3; ++i)
    if (piece.corner[i] == point) return i;
  return -1;
}

/// How far from a triangle a point is, about.
double distance_from(const Triangle2& t, Point2 p) { return length(place(t, barycentric(t, p)) - p); }

/// The coordinates on another piece, without rounding where all corners that count are its own; false if not.
bool keep_corners(const Rearrangement::Piece& from, const Rearrangement::Piece& to, const Barycentric& b,
                  Barycentric& out) {
  out = {};
  for (int i = 0; i < 3; ++i) {
    if (b[i] == 0) continue;
    const int there = corner_at(to, from.corner[i]);
    if (there < 0) return false;
    out[there] = b[i];
  }
  return true;
}

}  // namespace

Rearrangements::Rearrangements(Index triangles) : made_by_(triangles, no_index), replaced_by_(triangles, no_index) {}

Index Rearrangements::add(Rearrangement change) {
  const auto number = static_cast<Index>(changes_.size()), first = static_cast<Index>(made_by_.size());
  for (auto& piece : change.after) {
    if (piece.triangle == no_index) continue;
    piece.triangle = static_cast<Index>(made_by_.size());
    made_by_.push_back(number);
    replaced_by_.push_back(no_index);
  }
  for (const auto& piece : change.before)
    if (piece.triangle != no_index) replaced_by_[piece.triangle] = number;
  changes_.push_back(change);
  return first;
}

Barycentric Rearrangements::carry(const Rearrangement& change, const Rearrangement::Piece& from,
                                  const Rearrangement::Piece& to, const Barycentric& b) {
  Barycentric kept;
  if (keep_corners(from, to, b, kept)) return kept;
  return barycentric(layout_of(change, to), place(layout_of(change, from), b));
}

Place Rearrangements::locate(Place at) const {
  while (replaced_by_[at.triangle] != no_index) {
    const Rearrangement& change = changes_[replaced_by_[at.triangle]];
    const auto& from = change.before[change.before[0].triangle == at.triangle ? 0 : 1];
    const Point2 p = place(layout_of(change, from), at.b);
    const Rearrangement::Piece* best = nullptr;
    double nearest = infinity;
    Barycentric kept;
    for (const auto& piece : change.after) {
      if (piece.triangle == no_index) continue;
      const double away = distance_from(layout_of(change, piece), p);
      // A point on an edge that stays is where the edge is, whatever rounding says.
      const bool stays = keep_corners(from, piece, at.b, kept);
      if (stays || !best || away < nearest) best = &piece, nearest = away;
      if (stays) break;
    }
    at = {best->triangle, carry(change, from, *best, at.b)};
  }
  return at;
}

void Rearrangements::restore(const Piece& way, std::vector<Piece>& out) const {
  if (made_by_[way.triangle] == no_index) {
    out.push_back(way);
    return;
  }
  const Rearrangement& change = changes_[made_by_[way.triangle]];
  for (const auto& there : change.after) {
    if (there.triangle != way.triangle) continue;
    if (change.before[1].triangle != no_index) return restore_flip(change, there, way, out);
    const auto& before = change.before[0];
    return restore({before.triangle, carry(change, there, before, way.from), carry(change, there, before, way.to)},
                   out);
  }
}

/// Where a way crosses the edge that was there before, it is cut in two.
void Rearrangements::restore_flip(const Rearrangement& change, const Rearrangement::Piece& there, const Piece& way,
                                  std::vector<Piece>& out) const {
  const Rearrangement::Piece &first = change.before[0], &second = change.before[1];
  const Triangle2 here = layout_of(change, there);
  const Point2 a = change.points[0], along = change.points[1] - a;
  const Point2 p = place(here, way.from), q = place(here, way.to);
  const auto side = [&](const Barycentric& b, Point2 at) {
    // Exactly 0 on the edge and at its ends.
    Barycentric kept;
    const bool on_both = keep_corners(there, first, b, kept) && keep_corners(there, second, b, kept);
    return on_both ? 0 : cross(along, at - a);
  };
  const double sp = side(way.from, p), sq = side(way.to, q);
  const auto whole = [&](const Rearrangement::Piece& piece) {
    restore({piece.triangle, carry(change, there, piece, way.from), carry(change, there, piece, way.to)}, out);
  };
  if (sp >= 0 && sq >= 0) return whole(first);
  if (sp <= 0 && sq <= 0) return whole(second);
  const Point2 x = p + (sp / (sp - sq)) * (q - p);
  const double size = dot(along, along), share = size > 0 ? std::clamp(dot(along, x - a) / size, 0.0, 1.0) : 0;
  const auto crossing = [&](const Rearrangement::Piece& piece) {
    Barycentric b{};
    b[corner_at(piece, 0)] = 1 - share;
    b[corner_at(piece, 1)] = share;
    return b;
  };
  const auto &start = sp > 0 ? first : second, &end = sp > 0 ? second : first;
  restore({start.triangle, carry(change, there, start, way.from), crossing(start)}, out);
  restore({end.triangle, crossing(end), carry(change, there, end, way.to)}, out);
}

std::size_t Rearrangements::bytes() const {
  return changes_.size() * sizeof(Rearrangement) + (made_by_.size() + replaced_by_.size()) * sizeof(Index);
}

}  // namespace geodrome::aleksandrov
