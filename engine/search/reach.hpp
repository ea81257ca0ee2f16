// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "geodrome/engine/named_points.hpp"
#include "geodrome/shortest_path_map.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome {

/// Counts of the entries of a matrix by what they mean.
struct ReachCounts {
  std::uint64_t reached = 0, beyond_limit = 0, unreachable = 0, not_computed = 0;
  /// Faults of a solver: +inf within a component though no limit was set, and a number across components.
  std::uint64_t missed = 0, impossible = 0;
};

/// Returns the word of outputs for the outcome of a distance to or from a place: for NaN "off_part" if the place is
/// off the part that was asked for, else "dropped".
inline const char* reach_word(double distance, Reach reach, const Place& place) {
  if (std::isnan(distance)) return place.state == Place::State::off_part ? "off_part" : "dropped";
  if (reach == Reach::reached) return "reached";
  return reach == Reach::beyond_limit ? "beyond_limit" : "unreachable";
}

/// The component of the surface that a place lies in, by those of the vertices; one without distances is in none.
inline Index component_of(const SurfaceMesh& mesh, std::span<const Index> of_vertex, const Place& place) {
  if (!place.has_distances()) return no_index;
  const bool isolated = place.state == Place::State::isolated;
  return of_vertex[isolated ? place.vertex : mesh.triangles()[place.at.face][0]];
}

/// The component of each point, as `vertex_components` names it.
inline std::vector<Index> components_of(const SurfaceMesh& mesh, std::span<const NamedPoint> points) {
  const std::vector<Index> of_vertex = vertex_components(mesh);
  std::vector<Index> components;
  for (const NamedPoint& point : points) components.push_back(component_of(mesh, of_vertex, point.place));
  return components;
}

/// Adds one row: distances from a source in component `source` to targets in `components`.
inline void count_reach(std::span<const double> row, Index source, std::span<const Index> components, bool limited,
                        ReachCounts& counts) {
  for (std::size_t j = 0; j < row.size(); ++j) {
    const bool joined = source == components[j];
    if (std::isnan(row[j]))
      ++counts.not_computed;
    else if (std::isfinite(row[j]))
      ++(joined ? counts.reached : counts.impossible);
    else if (!joined)
      ++counts.unreachable;
    else
      ++(limited ? counts.beyond_limit : counts.missed);
  }
}

}  // namespace geodrome
