// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "geodrome/engine/selection.hpp"

namespace geodrome {

/// How the entries of a matrix are to be read.
struct ReachCounts {
  std::uint64_t reached = 0, beyond_limit = 0, unreachable = 0, not_computed = 0;
  /// Faults of a solver: +inf within a component though no limit was set, and a number across components.
  std::uint64_t missed = 0, impossible = 0;
};

/// Which component of the surface each query lies in: two points have a distance if and only if they share it.
class Components {
 public:
  explicit Components(const SurfaceMesh& mesh) : sets_(mesh.vertex_count()) {
    for (const Triangle& t : mesh.triangles()) {
      sets_.unite(t[0], t[1]);
      sets_.unite(t[1], t[2]);
    }
    triangles_ = mesh.triangles();
  }

  /// The lowest vertex of the component; a dropped place is in none.
  Index of(const Place& place) {
    if (place.state == Place::State::dropped) return no_index;
    return sets_.find(place.state == Place::State::isolated ? place.vertex : triangles_[place.at.face][0]);
  }

  std::vector<Index> of(std::span<const Query> queries) {
    std::vector<Index> components;
    for (const Query& query : queries) components.push_back(of(query.place));
    return components;
  }

 private:
  detail::DisjointSets sets_;
  std::span<const Triangle> triangles_;
};

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
