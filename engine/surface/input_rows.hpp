// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// The first row of the file that gave each entry of `positions`: what users know a point by.
inline std::vector<Index> rows_of_elements(const Input& input) {
  std::vector<Index> row_of(input.positions.size(), no_index);
  for (Index row = 0; row < input.element_of_row.size(); ++row) {
    const Index element = input.element_of_row[row];
    if (element != no_index && row_of[element] == no_index) row_of[element] = row;
  }
  return row_of;
}

/// Calls `visit(point, place)` once for every sample point that has a place on the surface; for none without a surface.
template <class Visitor>
void for_each_live_point(const Input& input, const PlacedSurface& surface, Visitor&& visit) {
  if (!surface.mesh) return;
  const std::vector<Index> row_of = rows_of_elements(input);
  for (Index point = 0; point < row_of.size(); ++point) {
    const Place& place = surface.places[row_of[point]];
    if (place.state == Place::State::on_surface) visit(point, place);
  }
}

}  // namespace geodrome
