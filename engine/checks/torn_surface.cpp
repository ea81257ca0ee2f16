// SPDX-License-Identifier: MIT
#include "engine/checks/torn_surface.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include "engine/input/point_tree.hpp"
#include "engine/surface/input_rows.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome {

namespace {

/// As many as a vertex of a triangulation has on average.
constexpr unsigned asked_neighbours = 6;

}  // namespace

std::optional<std::pair<Index, Index>> torn_neighbours(const Input& input, const PlacedSurface& surface) {
  if (!surface.mesh) return {};
  const std::vector<Index> components = vertex_components(*surface.mesh);
  std::vector<Vec3> points;
  std::vector<Index> rows, part;
  const std::vector<Index> row_of = rows_of_elements(input);
  for_each_live_point(input, surface, [&](Index point, const Place& place) {
    points.push_back(place.position), rows.push_back(row_of[point]);
    part.push_back(components[surface.mesh->triangles()[place.at.face][0]]);
  });
  if (std::ranges::adjacent_find(part, std::not_equal_to{}) == part.end()) return {};
  const input::PointTree tree = input::tree_of(points);
  for (Index i = 0; i < points.size(); ++i)
    for (auto at = tree.qbegin(boost::geometry::index::nearest(input::tree_point(points[i]), asked_neighbours + 1));
         at != tree.qend(); ++at)
      if (part[at->second] != part[i]) return std::pair{rows[i], rows[at->second]};
  return {};
}

}  // namespace geodrome
