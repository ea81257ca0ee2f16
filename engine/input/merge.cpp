// SPDX-License-Identifier: MIT
#include "engine/input/merge.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace geodrome::input {

MergedPoints merge_equal_points(std::span<const Vec3> points) {
  struct Row {
    Vec3 point;
    Index row;
  };
  std::vector<Row> rows(points.size());
  for (Index i = 0; i < points.size(); ++i) rows[i] = {points[i], i};
  // The comparison takes -0 and 0 for equal, as it should.
  const auto key = [](const Row& r) { return std::tie(r.point.x, r.point.y, r.point.z, r.row); };
  std::sort(rows.begin(), rows.end(), [&](const Row& a, const Row& b) { return key(a) < key(b); });

  MergedPoints merged;
  merged.element_of_row.resize(points.size());
  for (std::size_t i = 0, first = 0; i < rows.size(); ++i) {
    if (rows[i].point != rows[first].point) first = i;
    merged.element_of_row[rows[i].row] = rows[first].row;
  }
  for (Index i = 0; i < points.size(); ++i) {
    Index& element = merged.element_of_row[i];
    if (element == i) {
      element = static_cast<Index>(merged.positions.size());
      merged.positions.push_back(points[i]);
    } else {
      element = merged.element_of_row[element];  // the first of the place comes before i and is settled
    }
  }
  return merged;
}

void merge_vertices(Soup& soup) {
  MergedPoints merged = merge_equal_points(soup.positions);
  for (Index& corner : soup.corners) corner = merged.element_of_row[corner];
  soup.positions = std::move(merged.positions);
}

}  // namespace geodrome::input
