// SPDX-License-Identifier: MIT
#include "plugins/common/points/planar_cell.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome {
namespace {

/// Sine of the angle below which two edges count as one line: the sample then determines their crossing to less than
/// six digits.
constexpr double parallel_sine = 1e-10;

/// Returns where `cutter` crosses `edge`, which runs from a corner inside to `outer`. The corner `outer` stays if the
/// two are one line, so an edge without an end keeps having none.
CellCorner crossing(const HalfPlane& edge, const HalfPlane& cutter, const CellCorner& outer) {
  const double sine = edge.nx * cutter.ny - edge.ny * cutter.nx;
  if (std::abs(sine) <= parallel_sine) return outer;
  return {(edge.offset * cutter.ny - cutter.offset * edge.ny) / sine,
          (edge.nx * cutter.offset - cutter.nx * edge.offset) / sine};
}

}  // namespace

void PlanarCell::reset(double reach) {
  reach_ = reach;
  const double side = 2 * reach;  // corners that are not real are then clearly beyond reach
  corners_ = {{side, -side, {1, 0, side}},
              {side, side, {0, 1, side}},
              {-side, side, {-1, 0, side}},
              {-side, -side, {0, -1, side}}};
  measure();
}

bool PlanarCell::cut(const HalfPlane& half_plane) {
  if (half_plane.offset >= farthest_) return false;
  const std::size_t count = corners_.size();
  excess_.clear();
  for (const CellCorner& c : corners_) excess_.push_back(half_plane.nx * c.x + half_plane.ny * c.y - half_plane.offset);
  // The remaining corners are one run around the innermost, also where rounding makes signs alternate.
  const std::size_t innermost = std::min_element(excess_.begin(), excess_.end()) - excess_.begin();
  std::size_t last = innermost, kept = 1;
  while (kept < count && excess_[(last + 1) % count] <= 0) last = (last + 1) % count, ++kept;
  if (kept == count) return false;
  std::size_t first = innermost;
  while (excess_[(first + count - 1) % count] <= 0) first = (first + count - 1) % count, ++kept;

  scratch_.clear();
  for (std::size_t i = 0; i < kept; ++i) scratch_.push_back(corners_[(first + i) % count]);
  CellCorner leaving = crossing(corners_[last].edge, half_plane, corners_[(last + 1) % count]);
  leaving.edge = half_plane;
  const CellCorner& before = corners_[(first + count - 1) % count];
  CellCorner returning = crossing(before.edge, half_plane, before);
  returning.edge = before.edge;
  scratch_.push_back(leaving);
  scratch_.push_back(returning);
  corners_.swap(scratch_);
  measure();
  return true;
}

bool PlanarCell::real(std::size_t corner) const {
  const HalfPlane& arriving = corners_[(corner + corners_.size() - 1) % corners_.size()].edge;
  const CellCorner& c = corners_[corner];
  return arriving.site != no_index && c.edge.site != no_index && std::hypot(c.x, c.y) <= reach_;
}

bool PlanarCell::bounded() const {
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (!real(i)) return false;
  return true;
}

std::optional<double> PlanarCell::farthest_real() const {
  std::optional<double> distance;
  for (std::size_t i = 0; i < corners_.size(); ++i)
    if (real(i)) distance = std::max(distance.value_or(0), std::hypot(corners_[i].x, corners_[i].y));
  return distance;
}

std::optional<double> PlanarCell::farthest_edge() const {
  std::optional<double> distance;
  for (const CellCorner& c : corners_)
    if (c.edge.site != no_index) distance = std::max(distance.value_or(0), c.edge.offset);
  return distance;
}

void PlanarCell::measure() {
  double squared = 0;
  for (const CellCorner& c : corners_) squared = std::max(squared, c.x * c.x + c.y * c.y);
  farthest_ = std::sqrt(squared);
}

}  // namespace geodrome
