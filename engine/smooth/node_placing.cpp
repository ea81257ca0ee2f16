// SPDX-License-Identifier: MIT
#include "engine/smooth/node_placing.hpp"

#include <cmath>

namespace geodrome {

namespace {

/// A node this near to an edge, in spacings, is on it: which of the two faces it lies in must not hang on rounding, for
/// a run in the other direction is rounded differently.
constexpr double on_the_edge = 1e-9;

/// The direction across a piece in the plane of its face, and the share of the corners that a unit along it gains.
CurveNode across(const SmoothCharts& charts, const FlatPiece& piece) {
  const auto [p, q, r] = charts.mesh().corners(piece.face);
  const Vec3 side = q - p, other = r - p, normal = cross(side, other);
  const Vec3 along = (piece.to[1] - piece.from[1]) * side + (piece.to[2] - piece.from[2]) * other;
  const Vec3 turned = cross(normal, along), direction = turned / norm(turned);
  const double over = 1 / squared_norm(normal);
  const double b1 = dot(cross(direction, other), normal) * over, b2 = dot(cross(side, direction), normal) * over;
  return {.place = {{piece.face, {}}, direction},
          .across = {-(b1 + b2), b1, b2},
          .spacing = charts.spacing(piece.face),
          .expected_error = charts.expected_error(piece.face)};
}

/// The node at a share of the piece's length.
CurveNode node_on(const SmoothCharts& charts, const FlatPiece& piece, double share) {
  CurveNode node = across(charts, piece);
  for (int i = 0; i < 3; ++i) node.place.at.b[i] = piece.from[i] + share * (piece.to[i] - piece.from[i]);
  return node;
}

}  // namespace

void place_nodes(const SmoothCharts& charts, std::span<const FlatPiece> run, std::vector<CurveNode>& nodes) {
  const auto spacings = [&](const FlatPiece& piece) { return piece.length / charts.spacing(piece.face); };
  double total = 0;
  for (const FlatPiece& piece : run) total += spacings(piece);
  const double count = 2 * std::max(1.0, std::ceil(total / 2 - on_the_edge));
  nodes.push_back(node_on(charts, run.front(), 0));
  std::size_t i = 0;
  double begin = 0, length = spacings(run[0]);  // of piece i
  for (double k = 1; k < count; ++k) {
    const double at = k * (total / count);
    while (i + 1 < run.size() && at > begin + length - on_the_edge) begin += length, length = spacings(run[++i]);
    const bool on_edge = i > 0 && at < begin + on_the_edge;
    if (on_edge && run[i - 1].face < run[i].face)
      nodes.push_back(node_on(charts, run[i - 1], 1));
    else
      nodes.push_back(node_on(charts, run[i], std::clamp((at - begin) / length, 0.0, 1.0)));
  }
  nodes.push_back(node_on(charts, run.back(), 1));
}

}  // namespace geodrome
