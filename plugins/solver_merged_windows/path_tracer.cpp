// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/path_tracer.hpp"

#include <algorithm>
#include <tuple>

#include "plugins/common/mesh/face_below.hpp"

namespace geodrome::merged_windows {

void PathTracer::from_vertex(Index vertex) {
  while (upper_.step(vertex).vertex != vertex) {
    out_.push_back(surface_.mesh().at_vertex(surface_.original_vertex(vertex)));
    const Step& step = upper_.step(vertex);
    if (step.window != no_index) {
      const Index half_edge = kept_.half_edge_of(step.window);
      const auto [x, y] = PackedMesh::apex(surface_.face_of(half_edge), static_cast<int>(half_edge % 3));
      vertex = through(step.window, x, y);
    } else {
      vertex = step.vertex;
    }
    if (vertex == no_index) return;
  }
}

void PathTracer::from_point(Index window, double x, double y) {
  const Index vertex = through(window, x, y);
  if (vertex != no_index) from_vertex(vertex);
}

/// Appends the crossings up to the pseudo-source; returns it, or no_index if that is a source that is no vertex.
Index PathTracer::through(Index window, double x, double y) {
  for (;;) {
    const KeptWindow& w = kept_[window];
    const Index half_edge = kept_.half_edge_of(window);
    const double climb = y - w.y;
    const double place = climb > 0 ? w.x + (x - w.x) * (-w.y / climb) : x;
    const double crossed = std::clamp(place, w.low, w.high);
    out_.push_back(surface_.original(surface_.point_on(half_edge, crossed)));
    const KeptWindow& old = kept_[unmerged(window, half_edge, crossed)];
    if (old.parent == no_index) return old.origin < surface_.vertex_count() ? old.origin : no_index;
    std::tie(x, y) = on_face_below(surface_, half_edge, crossed, kept_.half_edge_of(old.parent));
    window = old.parent;
  }
}

/// Of the windows that were merged into this one, if any were, the one that has a place of the half-edge.
Index PathTracer::unmerged(Index window, Index half_edge, double place) const {
  Index old = kept_[window].parent;
  if (old == no_index || kept_.half_edge_of(old) != half_edge) return window;
  while (kept_[old].high < place) ++old;
  return old;
}

}  // namespace geodrome::merged_windows
