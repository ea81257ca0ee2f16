// SPDX-License-Identifier: MIT
// What a propagation tells after a run.
#include "plugins/solver_chen_han/path_tracer.hpp"
#include "plugins/solver_chen_han/propagation.hpp"

namespace geodrome::chen_han {

Propagation::Way Propagation::way_to(const SurfacePoint& inner, double best) const {
  Way way;
  for (Index h = 3 * inner.face; h < 3 * inner.face + 3; ++h) {
    const auto [x, y] = surface_.in_frame(h, inner.b);
    kept_.for_each(h, [&, x = x, y = y](Index number, const Window& window) {
      const double distance = way_through(window, x, y, best);
      if (distance < best) best = distance, way = {distance, source_of(window.origin), number, x, y};
    });
  }
  return way;
}

void Propagation::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, labels_, kept_, out).from_point(way.window, way.x, way.y);
}

void Propagation::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, labels_, kept_, out).from_vertex(vertex);
}

std::array<Counter, 8> Propagation::counters() const {
  return {{{"windows_created", counts_.created},
           {"windows_propagated", counts_.propagated},
           {"windows_filtered", counts_.filtered},
           {"windows_trimmed", counts_.trimmed},
           {"half_edges_passed", counts_.passes},
           {"vertices_emitted", emissions()},
           {"largest_window_list", counts_.longest},
           {"largest_search_bytes", bytes()}}};
}

std::size_t Propagation::bytes() const {
  return VertexPropagation::bytes() + wavefront_.bytes() + trimming_.bytes() + fans_.bytes() + kept_.bytes() +
         gathering_.bytes() + chosen_left_.bytes() + chosen_right_.bytes();
}

}  // namespace geodrome::chen_han
