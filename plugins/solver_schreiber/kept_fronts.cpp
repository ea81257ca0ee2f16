// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/kept_fronts.hpp"

namespace geodrome::schreiber {

Crossing way_through(const Generator& g, double length, double px, double py, double best) {
  const double straight = g.to(px, py);
  if (!(straight < best)) return {straight, 0};
  const double climb = py - g.y;
  const double x = climb > 0 ? g.x + (px - g.x) * (-g.y / climb) : px;
  if (g.covers(px, py)) return {straight, std::clamp(x, 0.0, length)};
  const double low = g.low(length), high = g.high(length);
  if (low <= x && x <= high) return {straight, x};
  const double end = x < low ? low : high;
  return {g.at(end) + std::sqrt((px - end) * (px - end) + py * py), end};
}

}  // namespace geodrome::schreiber
