// SPDX-License-Identifier: MIT
// The members of Propagation that answer after a run.
#include "plugins/solver_schreiber/claimant.hpp"
#include "plugins/solver_schreiber/path_tracer.hpp"
#include "plugins/solver_schreiber/propagation.hpp"

namespace geodrome::schreiber {

Propagation::Way Propagation::way_to(const SurfacePoint& inner, double best) const {
  Way way;
  const double until = best + surface_.longest_side(inner.face);
  for (Index h = 3 * inner.face; h < 3 * inner.face + 3; ++h) {
    const auto [x, y] = surface_.in_frame(h, inner.b);
    kept_.for_each(h, no_index, [&, x = x, y = y](const Front& front, Index number) {
      const Generator g = owner_at(front, x, y, until);
      const Crossing crossing = way_through(g, surface_.length(h), x, y, best);
      if (!(crossing.distance < best)) return;
      best = crossing.distance;
      way = {best, source_of(g.origin), {crossing.place, h, no_index, number, g.origin}};
    });
  }
  return way;
}

void Propagation::trace(const Way& way, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, labels_, kept_, sources_, out).from_crossing(way.step);
}

void Propagation::trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const {
  PathTracer(surface_, labels_, kept_, sources_, out).from_vertex(vertex);
}

std::array<Counter, 13> Propagation::counters() const {
  const FrontCounts& fronts = editor_.counts();
  return {{{"half_edges_passed", counts_.passes},
           {"half_edges_passed_again", counts_.repeated},
           {"most_passes_of_a_half_edge", counts_.most},
           {"generators_carried", counts_.carried},
           {"bisector_events", fronts.events},
           {"fronts_joined", fronts.joins},
           {"fronts_split", fronts.splits},
           {"fronts_merged_point_by_point", fronts.envelopes},
           {"fronts_carried_one_by_one", counts_.tangled},
           {"vertices_emitted", emissions()},
           {"nodes_made", pool_.nodes_made() - nodes_before_},
           {"largest_front", counts_.longest},
           {"largest_search_bytes", bytes()}}};
}

std::size_t Propagation::bytes() const {
  return VertexPropagation::bytes() + pool_.bytes() + fans_.bytes() + waiting_.bytes() + kept_.bytes() +
         times_passed_.capacity() + passed_.capacity() * sizeof(Index);
}

}  // namespace geodrome::schreiber
