// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/path_tracer.hpp"

#include <cmath>
#include <string>

#include "plugins/common/exact/tolerances.hpp"
#include "plugins/solver_schreiber/claimant.hpp"

namespace geodrome::schreiber {

/// A shortest path meets no vertex and no edge twice. One that does, through edges without length, would never end.
void PathTracer::append(const SurfacePoint& point) {
  const SurfaceMesh& mesh = surface_.mesh();
  if (out_.size() > mesh.vertex_count() + 3 * mesh.face_count())
    throw NumericalError("the path runs in a circle near face " + std::to_string(point.face),
                         "merge the vertices at one place, or choose another solver");
  out_.push_back(point);
}

void PathTracer::from_vertex(Index vertex) {
  while (labels_[vertex].corner != no_index) {
    append(surface_.mesh().at_vertex(surface_.original_vertex(vertex)));
    const Step& step = labels_.step(vertex);
    vertex = step.half_edge != no_index ? follow(step, {labels_.distance(vertex), step.origin}) : step.vertex;
    if (vertex == no_index) return;
  }
}

void PathTracer::from_crossing(const Step& step) {
  const Index vertex = follow(step, {infinity, step.origin});
  if (vertex != no_index) from_vertex(vertex);
}

/// Appends the crossings up to the pseudo-source. Returns its vertex, or no_index if it is a source that is no vertex.
Index PathTracer::follow(Step step, const Start& start) {
  for (;;) {
    append(surface_.original(surface_.point_on(step.half_edge, step.crossing)));
    Onward best, over_corner;
    surface_.for_each_across(step.half_edge, [&](Index below, bool mirrored) {
      const double x = mirrored ? step.crossing : surface_.length(step.half_edge) - step.crossing;
      const Onward corner = shortest_over_corners(below, x, start);
      if (corner.distance < over_corner.distance) over_corner = corner;
      look_for_origin(step, below, x, best);
      look_below(step, start, below, x, over_corner.distance, best);
    });
    // A front may have a gap beside a vertex at which paths bend by next to nothing. The path over that vertex is taken
    // only if it is shorter, by more than rounding, than through any face of the edge, so that it cannot lead back.
    if (over_corner.distance < (1 - rounding_share) * best.distance) best = over_corner;
    step = best.step;
    if (step.half_edge == no_index) return step.vertex;
  }
}

/// Considers the straight path to the origin of the generator, if the origin is in the face below. `x` is the place on
/// `half_edge`, which is one of that face.
void PathTracer::look_for_origin(const Step& from, Index half_edge, double x, Onward& best) const {
  const Index face = half_edge / 3;
  const std::array<double, 3> b = surface_.point_on(half_edge, x).b;
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    if (surface_.from(corner) != from.origin) continue;
    const auto [cx, cy] = surface_.in_frame(corner, b);
    const double distance = labels_.distance(from.origin) + std::hypot(cx, cy);
    if (distance < best.distance) best = {distance, {.vertex = from.origin}};
  }
  const std::size_t vertices = surface_.vertex_count();
  if (from.origin < vertices) return;
  const auto [x0, y0] = surface_.in_frame(3 * face, b);
  for (const SeededFace& source : sources_) {
    if (source.at.face != face || source.number != from.origin - vertices) continue;
    const auto [sx, sy] = surface_.in_frame(3 * face, source.at.b);
    const double distance = source.start + std::hypot(sx - x0, sy - y0);
    if (distance < best.distance) best = {distance, {}};
  }
}

/// Considers the fronts kept before, for a point at distance `most` or less. The origin is preferred to a front that is
/// shorter by rounding only.
void PathTracer::look_below(const Step& from, const Start& start, Index half_edge, double x, double most,
                            Onward& best) const {
  constexpr double as_short = 1 - 4 * std::numeric_limits<double>::epsilon();
  const std::array<double, 3> b = surface_.point_on(half_edge, x).b;
  const double until = most + surface_.longest_side(half_edge / 3);
  for (const Index h : {SurfaceMesh::next(half_edge), SurfaceMesh::previous(half_edge)}) {
    const auto [px, py] = surface_.in_frame(h, b);
    kept_.for_each(h, from.front, [&, px = px, py = py](const Front& front, Index number) {
      const Generator g = owner_at(front, px, py, until);
      const Crossing crossing = way_through(g, surface_.length(h), px, py, best.distance);
      if (crossing.distance < as_short * best.distance && leads_on(start, g.origin))
        best = {crossing.distance, {crossing.place, h, no_index, number, g.origin}};
    });
  }
}

/// Tells whether a path may go on to rays of an origin, or over that vertex. It may not go to a vertex that is as far
/// as the one it leads from: it would lead back to that one, or to another in its place.
bool PathTracer::leads_on(const Start& start, Index origin) const {
  return origin == start.origin || origin >= surface_.vertex_count() ||
         labels_.distance(origin) < (1 - rounding_share) * start.distance;
}

/// Returns the path over the best corner of the face below.
PathTracer::Onward PathTracer::shortest_over_corners(Index half_edge, double x, const Start& start) const {
  const std::array<double, 3> b = surface_.point_on(half_edge, x).b;
  const Index face = half_edge / 3;
  Onward best;
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    const auto [cx, cy] = surface_.in_frame(corner, b);
    const double distance = labels_.distance(surface_.from(corner)) + std::hypot(cx, cy);
    if (distance < best.distance && leads_on(start, surface_.from(corner)))
      best = {distance, {.vertex = surface_.from(corner)}};
  }
  return best;
}

}  // namespace geodrome::schreiber
