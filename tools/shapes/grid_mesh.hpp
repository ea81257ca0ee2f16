// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome::shapes {

enum class Diagonals {
  parallel,    ///< from (column, row) to (column + 1, row + 1)
  chess_board  ///< crossing ones in turn, so that the grid is as symmetric as its triangles allow
};

/// Triangles of columns x rows quads; vertex (i, j) is `first` + j * width + i, where width is columns + 1, or columns
/// if the rows are closed. They face the side from which column, row turn counterclockwise.
inline std::vector<Triangle> grid_triangles(Index columns, Index rows, bool closed_rows, Diagonals diagonals,
                                            Index first = 0) {
  const Index width = closed_rows ? columns : columns + 1;
  std::vector<Triangle> triangles;
  triangles.reserve(2 * std::size_t{columns} * rows);
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = first + j * width + i, b = first + j * width + (i + 1) % width, c = b + width, d = a + width;
      if (diagonals == Diagonals::chess_board && (i + j) % 2 == 1)
        triangles.push_back({a, b, d}), triangles.push_back({b, c, d});
      else
        triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
    }
  return triangles;
}

/// An open grid of columns x rows quads with vertex (i, j) at place(i, j).
template <class Place>
SurfaceMesh grid_mesh(Index columns, Index rows, Diagonals diagonals, Place&& place) {
  std::vector<Vec3> positions;
  positions.reserve((std::size_t{columns} + 1) * (std::size_t{rows} + 1));
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) positions.push_back(place(i, j));
  return SurfaceMesh(std::move(positions), grid_triangles(columns, rows, false, diagonals));
}

}  // namespace geodrome::shapes
