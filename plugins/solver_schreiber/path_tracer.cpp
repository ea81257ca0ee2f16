// SPDX-License-Identifier: MIT
#include "solver_schreiber/path_tracer.hpp"

#include <algorithm>

#include "solver_schreiber/claimant.hpp"

namespace geodrome::schreiber {

void PathTracer::from_vertex(Index vertex) {
  while (labels_[vertex].corner != no_index) {
    out_.push_back(surface_.mesh().at_vertex(surface_.original_vertex(vertex)));
    const Step& step = labels_.step(vertex);
    vertex = step.half_edge != no_index ? follow(step) : step.vertex;
    if (vertex == no_index) return;
  }
}

void PathTracer::from_crossing(const Step& step) {
  const Index vertex = follow(step);
  if (vertex != no_index) from_vertex(vertex);
}

/// Appends the crossings up to the pseudo-source; returns it, or no_index if that is a source that is no vertex.
Index PathTracer::follow(Step step) {
  for (;;) {
    out_.push_back(surface_.original(surface_.point_on(step.half_edge, step.crossing)));
    const Onward next = onward(step.half_edge, step.crossing);
    if (next.half_edge == no_index) return next.vertex;
    step = {next.crossing, next.half_edge};
  }
}

/// The shortest way on from the point.
PathTracer::Onward PathTracer::onward(Index half_edge, double x) const {
  Onward best;
  surface_.for_each_across(half_edge, [&](Index below, bool mirrored) {
    look_below(below, mirrored ? x : surface_.length(half_edge) - x, best);
  });
  return best;
}

/// `x` is the place on `half_edge`, of the face below. A corner is taken before a front that is shorter by rounding
/// only: from a point at a vertex fronts could lead around it for ever.
void PathTracer::look_below(Index half_edge, double x, Onward& best) const {
  constexpr double as_short = 1 - 4 * std::numeric_limits<double>::epsilon();
  const Index face = half_edge / 3;
  const std::array<double, 3> b = surface_.point_on(half_edge, x).b;
  for (Index i = 0; i < 3; ++i) {
    const Index corner = 3 * face + i, vertex = surface_.from(corner);
    if (labels_[vertex].source == no_index) continue;
    const auto [cx, cy] = surface_.in_frame(corner, b);
    const double distance = labels_.distance(vertex) + std::hypot(cx, cy);
    if (distance < best.distance) best = {distance, no_index, vertex};
  }
  const auto [x0, y0] = surface_.in_frame(3 * face, b);
  for (const SeededFace& source : sources_) {
    if (source.at.face != face) continue;
    const auto [sx, sy] = surface_.in_frame(3 * face, source.at.b);
    const double distance = source.start + std::hypot(sx - x0, sy - y0);
    if (distance < best.distance) best = {distance};
  }
  const double until = best.distance + surface_.longest_side(face);
  for (const Index h : {SurfaceMesh::next(half_edge), SurfaceMesh::previous(half_edge)}) {
    const auto [px, py] = surface_.in_frame(h, b);
    kept_.for_each(h, [&, px = px, py = py](const Front& front) {
      const Generator g = owner_at(front, px, py, until);
      const Crossing crossing = way_through(g, surface_.length(h), px, py, best.distance);
      if (crossing.distance < as_short * best.distance) best = {crossing.distance, h, no_index, crossing.place};
    });
  }
}

}  // namespace geodrome::schreiber
