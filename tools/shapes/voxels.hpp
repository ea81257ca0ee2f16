// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tools/shapes/implicit.hpp"

namespace geodrome::shapes {

/// The place of a cell in a grid, or of the grid corner that is its lowest one.
using Cell = std::array<std::int32_t, 3>;

/// A grid of cubes that covers the box of an implicit surface, symmetric about the origin.
struct VoxelGrid {
  double spacing;
  Cell count;

  VoxelGrid(const Implicit& surface, double spacing);
  Vec3 corner(const Cell& cell) const {
    const auto along = [&](int axis) { return (cell[axis] - 0.5 * count[axis]) * spacing; };
    return {along(0), along(1), along(2)};
  }
};

/// All cells that the surface passes through, perhaps a few others close to it, sorted. Complete: cells are ruled out
/// by Taylor's bound with `second_derivative`. Time grows with the area in cells, not with the volume.
std::vector<Cell> cells_near(const Implicit& surface, const VoxelGrid& grid);

}  // namespace geodrome::shapes
