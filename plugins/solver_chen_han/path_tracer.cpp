// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/path_tracer.hpp"

#include <algorithm>

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
    std::tie(x, y) = on_face_below(half_edge, crossed, kept_.half_edge_of(w.parent));
    window = w.parent;
  }
}

/// Point x of a half-edge in the frame of the half-edge `parent` of the face below, through which the window came.
std::pair<double, double> PathTracer::on_face_below(Index half_edge, double x, Index parent) const {
  const PackedMesh::Face& face = surface_.face_of(parent);
  for (const Index edge : {SurfaceMesh::previous(parent), SurfaceMesh::next(parent)}) {
    double along = -1;
    surface_.for_each_across(edge, [&](Index other, bool mirrored) {
      if (other == half_edge) along = mirrored ? x : surface_.length(edge) - x;
    });
    if (along < 0) continue;
    const double share = face.length[edge % 3] > 0 ? along / face.length[edge % 3] : 0;
    std::array<double, 3> b{};
    b[edge % 3] = 1 - share;
    b[(edge + 1) % 3] = share;
    return surface_.in_frame(parent, b);
  }
  return {x, 0};
}

}  // namespace geodrome::chen_han
