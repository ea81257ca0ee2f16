// SPDX-License-Identifier: MIT
#include "tools/shapes/voxels.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::shapes {
namespace {

/// Halves the box of cells [low, high) until it is ruled out or a single cell.
void collect(const Implicit& surface, const VoxelGrid& grid, const Cell& low, const Cell& high,
             std::vector<Cell>& found) {
  const Vec3 bottom = grid.corner(low), top = grid.corner(high);
  const LevelValue f = surface.at(0.5 * (bottom + top));
  const double radius = 0.5 * norm(top - bottom);
  if (std::abs(f.value) > radius * (norm(f.gradient) + 0.5 * radius * surface.second_derivative)) return;
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
  if (high[axis] - low[axis] == 1) {
    found.push_back(low);
    return;
  }
  Cell middle_low = low, middle_high = high;
  middle_low[axis] = middle_high[axis] = (low[axis] + high[axis]) / 2;
  collect(surface, grid, low, middle_high, found);
  collect(surface, grid, middle_low, high, found);
}

}  // namespace

VoxelGrid::VoxelGrid(const Implicit& surface, double spacing) : spacing(spacing) {
  const auto cells = [&](double half) { return static_cast<std::int32_t>(std::ceil(2 * half / spacing)); };
  count = {cells(surface.half_extent.x), cells(surface.half_extent.y), cells(surface.half_extent.z)};
}

std::vector<Cell> cells_near(const Implicit& surface, const VoxelGrid& grid) {
  std::vector<Cell> found;
  collect(surface, grid, {0, 0, 0}, grid.count, found);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace geodrome::shapes
