// SPDX-License-Identifier: MIT
#include "engine/smooth/fronts/crossing.hpp"

#include <cmath>

#include "engine/smooth/fronts/arrival.hpp"
#include "engine/smooth/piece_length.hpp"

namespace geodrome {

namespace {

constexpr int most_steps = 6;
/// Newton's steps end here, in shares of the edge. A gradient is wanted as exact as the directions that it is made of;
/// for the distance alone, where what is missing is squared, less is enough.
constexpr double near_for_gradient = 1e-5, near_for_distance = 3e-3;
/// How far beyond an edge its curve is believed.
constexpr double beyond = 0.3;
/// Nearer to the source than this many lengths of the edge, what the square of a distance is off by is too much of the
/// distance.
constexpr double nearest = 1;
/// Where a path runs along an edge, in squares of the sine, its circles cannot be seen there.
constexpr double grazing = 0.05;

/// The circle at a crossing, by the distances along the edge.
double spread_at(const EdgeFront::Slopes& d, const CurvePoint& at, const Heading& back) {
  const double across = dot(back.left, at.first), squared = across * across;
  if (!(squared > grazing * squared_norm(at.first))) return std::numeric_limits<double>::quiet_NaN();
  return (d.second + dot(back.along, at.second)) / squared;
}

/// The way back leads to the side of the edge where the source is.
bool comes_from_source(const EdgeFront& front, const CurvePoint& at, double share, const Heading& back) {
  const Vec3 over = cross(at.normal, at.first);
  return dot(front.gradient(share), over) * dot(back.along, over) < 0;
}

}  // namespace

std::optional<Crossing> find_crossing(const EdgeFront& front, const PieceEnd& to, double share) {
  const double near = to.turn ? near_for_gradient : near_for_distance;
  for (int k = 0; k < most_steps; ++k) {
    const CurvePoint at = front.curve().at(share);
    const EdgeFront::Slopes d = front.at(share);
    const Vec3 chord = to.position - at.position;
    const double straight = norm(chord);
    const Heading back = arriving(-chord / straight, to.normal, at.normal);  // at the edge, from the point
    const double across = dot(back.left, at.first), slope = d.first + dot(back.along, at.first);
    const double bend = d.second + dot(back.along, at.second) + across * across / straight;
    const double step = -slope / bend;
    if (!(bend > 0) || !(std::abs(step) < 1)) return std::nullopt;
    share += step;
    if (share < -beyond || share > 1 + beyond) return Crossing{share};
    if (std::abs(step) > near) continue;
    if (d.value < nearest * front.curve().length || !comes_from_source(front, at, share, back)) return std::nullopt;
    const double length = length_between({at.position, at.normal, {}, {}, {}}, {to.position, to.normal, {}, {}, {}});
    Crossing found{share, d.value + length + 0.5 * step * slope, length, norm(to.normal - at.normal)};
    if (!to.turn) return found;
    found.gradient = arriving(chord / straight, length, at.normal, to.normal, *to.turn);
    found.spread = spread_at(d, at, back);
    return found;
  }
  return std::nullopt;
}

}  // namespace geodrome
