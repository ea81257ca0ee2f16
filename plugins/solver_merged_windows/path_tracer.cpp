// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/path_tracer.hpp"

#include <algorithm>
#include <tuple>

#include "plugins/common/mesh/face_below.hpp"

namespace geodrome::merged_windows {

void PathTracer::from_vertex(Index vertex) { along(upper_.way_to(vertex)); }

void PathTracer::from_point(Index window, double x, double y) { along(through(window, x, y)); }

/// Appends the vertex that a way leads to and what comes before it, back to the source, without that.
void PathTracer::along(Index way) {
  while (way != no_index && !upper_.way(way).step.at_source) {
    const auto& [step, vertex] = upper_.way(way);
    out_.push_back(surface_.mesh().at_vertex(surface_.original_vertex(vertex)));
    way = step.before;
    if (step.window == no_index) continue;
    const Index half_edge = kept_.half_edge_of(step.window);
    const auto [x, y] = PackedMesh::apex(surface_.face_of(half_edge), static_cast<int>(half_edge % 3));
    way = through(step.window, x, y);
  }
}

/// Appends the crossings up to the pseudo-source; returns the way to it, or no_index if that is a source that is no
/// vertex.
Index PathTracer::through(Index window, double x, double y) {
  for (;;) {
    const KeptWindow& w = kept_[window];
    const Index half_edge = kept_.half_edge_of(window);
    const double climb = y - w.y;
    const double place = climb > 0 ? w.x + (x - w.x) * (-w.y / climb) : x;
    const double crossed = std::clamp(place, w.low, w.high);
    out_.push_back(surface_.original(surface_.point_on(half_edge, crossed)));
    const KeptWindow& old = kept_[unmerged(window, half_edge, crossed)];
    if (!old.came_from_window()) return old.way();
    std::tie(x, y) = on_face_below(surface_, half_edge, crossed, kept_.half_edge_of(old.parent));
    window = old.parent;
  }
}

/// Of the windows that were merged into this one, if any were, the one that has a place of the half-edge.
Index PathTracer::unmerged(Index window, Index half_edge, double place) const {
  if (!kept_[window].came_from_window()) return window;
  Index old = kept_[window].parent;
  if (kept_.half_edge_of(old) != half_edge) return window;
  while (kept_[old].high < place) ++old;
  return old;
}

}  // namespace geodrome::merged_windows
