// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/direct_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace geodrome::chen_han {
namespace {

/// A direct path is kept unless another path is shorter by this share of its length and of the longest edge: more than
/// the rounding of both, which for a path shorter than the edges around it depends on these.
constexpr double longer_share = 4 * rounding_share;
/// The error of two directions together (rad), as in emission.cpp.
constexpr double direction_error = 1e-3;

}  // namespace

std::span<const FoundPath> DirectSearch::run(Index source, double limit, const RunContext& context) {
  propagation_.begin_direct(direct_, source, limit);
  propagation_.run(context, [] { return infinity; });
  paths_.clear();
  any_ = 0;
  const bool directed = angles_.has_directions(source);
  for (const Index v : propagation_.reached()) {
    const Label& label = propagation_.label(v);
    const double longest = direct_.bound(v) + longer_share * (direct_.bound(v) + longest_edge_);
    if (v == source || label.distance > limit || label.distance > longest) continue;
    const Bearing exit = direct_.exit(v);
    FoundPath path{label.distance, v, 0, arrival(v, label)};
    if (directed && is_known(exit)) path.exit = code(source, radians(exit));
    paths_.push_back(path);
    if (label.all_sides() || !is_known(exit)) std::swap(paths_[any_++], paths_.back());
  }
  return paths_;
}

DirectList DirectSearch::list(Index source, double limit, const RunContext& context) {
  run(source, limit, context);
  std::sort(
      paths_.begin() + static_cast<std::ptrdiff_t>(any_), paths_.end(),
      [](const FoundPath& a, const FoundPath& b) { return a.exit != b.exit ? a.exit < b.exit : a.target < b.target; });
  const bool closed = surface_.kind(source) == PackedMesh::VertexKind::saddle;
  return DirectList(paths_, any_, half_turn(source), closed);
}

DirectionCode DirectSearch::half_turn(Index vertex) const {
  if (!angles_.has_directions(vertex)) return 0;
  const double share = (std::numbers::pi - direction_error) / angles_.total(vertex);
  return static_cast<DirectionCode>(std::max(0.0, std::floor(share * full_angle) - 2));
}

/// A direction at a vertex as a code. Rounding may have put it a little before 0 or beyond the total angle.
DirectionCode DirectSearch::code(Index vertex, double direction) const {
  const double share = direction / angles_.total(vertex), steps = std::round(share * full_angle);
  if (surface_.kind(vertex) == PackedMesh::VertexKind::saddle) {
    const double wrapped = steps < 0 ? steps + full_angle : steps >= full_angle ? steps - full_angle : steps;
    return static_cast<DirectionCode>(std::clamp(wrapped, 0.0, full_angle - 1.0));
  }
  return static_cast<DirectionCode>(std::clamp(steps, 0.0, static_cast<double>(full_angle)));
}

DirectionCode DirectSearch::arrival(Index vertex, const Label& label) const {
  if (surface_.kind(vertex) == PackedMesh::VertexKind::smooth) return ends_here;
  if (label.all_sides() || !angles_.has_directions(vertex)) return to_all_sides;
  return code(vertex, angles_.direction(label.corner, label.side));
}

}  // namespace geodrome::chen_han
