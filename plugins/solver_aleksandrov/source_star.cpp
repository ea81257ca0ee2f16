// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/source_star.hpp"

#include <algorithm>

namespace geodrome::aleksandrov {

SourceStar source_star(const SteinerGraph& graph, Index vertex) {
  double width = infinity, lightest = width;
  for (const Index h : graph.corners_at(vertex)) {
    const auto& next = graph.corner(SurfaceMesh::next(h));
    width = std::min(width, graph.corner(h).length * 2 * next.cosine * next.sine);
    lightest = std::min(lightest, graph.weight(h / 3));
  }
  return {width, lightest * width};
}

SurfacePoint scaled(const SurfacePoint& at, Index i, double scale) {
  const Index j = (i + 1) % 3, k = (i + 2) % 3;
  SurfacePoint moved = at;
  moved.b[j] *= scale, moved.b[k] *= scale;
  moved.b[i] = 1 - moved.b[j] - moved.b[k];
  return moved;
}

}  // namespace geodrome::aleksandrov
