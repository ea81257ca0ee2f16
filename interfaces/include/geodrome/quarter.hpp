// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// One triangle becomes four by new vertices on its edges, each at `place(p, q)` for an edge from p to q: those of face
/// f are 4 f to 4 f + 3, at its corners in their order and in the middle.
template <class Place>
void quarter(std::vector<Vec3>& positions, std::vector<Triangle>& triangles, Place&& place) {
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, is_new] = middles.emplace(std::minmax(a, b), static_cast<Index>(positions.size()));
    if (is_new) positions.push_back(place(positions[a], positions[b]));
    return entry->second;
  };
  std::vector<Triangle> finer;
  finer.reserve(4 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  triangles = std::move(finer);
}

}  // namespace geodrome
