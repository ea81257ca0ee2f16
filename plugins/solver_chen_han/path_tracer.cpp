// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/path_tracer.hpp"

#include <algorithm>
#include <tuple>

#include "plugins/common/mesh/face_below.hpp"

namespace geodrome::chen_han {

void PathTracer::from_vertex(Index vertex) {
  while (labels_[vertex].corner != no_index) {
    out_.push_back(surface_.mesh().at_vertex(surface_.original_vertex(vertex)));
    const Step& step = labels_.step(vertex);
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
    const Window& w = kept_[window];
    const Index half_edge = kept_.half_edge_of(window);
    const double climb = y - w.y;
    const double place = climb > 0 ? w.x + (x - w.x) * (-w.y / climb) : x;
    const double crossed = std::clamp(place, w.low, w.high);
    out_.push_back(surface_.original(surface_.point_on(half_edge, crossed)));
    if (w.parent == no_index) return w.origin < surface_.vertex_count() ? w.origin : no_index;
    std::tie(x, y) = on_face_below(surface_, half_edge, crossed, kept_.half_edge_of(w.parent));
    window = w.parent;
  }
}

}  // namespace geodrome::chen_han
