// SPDX-License-Identifier: MIT
// What a propagation tells after a run.
#include "plugins/solver_merged_windows/path_tracer.hpp"
#include "plugins/solver_merged_windows/propagation.hpp"

namespace geodrome::merged_windows {

Propagation::Way Propagation::way_to(const SurfacePoint& inner, double best) const {
  Way way;
  for (Index h = 3 * inner.face; h < 3 * inner.face + 3; ++h) {
    const auto [x, y] = surface_.in_frame(h, inner.b);
    kept_.for_each(h, [&, x = x, y = y](Index number, const KeptWindow& window) {
      const double distance = way_through(window, x, y);
      if (distance < best) best = distance, way = {distance, source_of(window.origin), number, x, y};
    });
  }
  return way;
}

void Propagation::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, upper_, kept_, out).from_point(way.window, way.x, way.y);
}

void Propagation::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, upper_, kept_, out).from_vertex(vertex);
}

std::array<Counter, 10> Propagation::counters() const {
  return {{{"windows_created", counts_.created},
           {"windows_propagated", counts_.propagated},
           {"windows_filtered", counts_.filtered},
           {"windows_trimmed", trimming_.dropped()},
           {"merges_tried", merging_.counts().tried},
           {"merges_done", merging_.counts().done},
           {"half_edges_passed", counts_.passes},
           {"vertices_emitted", emissions()},
           {"largest_window_list", counts_.longest},
           {"largest_search_bytes", bytes()}}};
}

std::size_t Propagation::bytes() const {
  const std::size_t windows =
      list_.capacity() + child_.capacity() + chosen_.capacity() + gathered_.capacity() + parts_.capacity();
  return VertexPropagation::bytes() + wavefront_.bytes() + merging_.bytes() + upper_.bytes() + fans_.bytes() +
         kept_.bytes() + windows * sizeof(Window);
}

}  // namespace geodrome::merged_windows
