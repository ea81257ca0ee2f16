// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "geodrome/errors.hpp"
#include "geodrome/run_context.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/entry.hpp"
#include "plugins/common/exact/found_distance.hpp"
#include "plugins/common/exact/pseudo_source.hpp"
#include "plugins/common/exact/tolerances.hpp"
#include "plugins/common/exact/watched_target.hpp"
#include "plugins/common/mesh/apex.hpp"
#include "plugins/common/mesh/emission.hpp"
#include "plugins/common/mesh/labels.hpp"

namespace geodrome {

/// The base of exact propagations, whatever carries their straight lines across faces: labels of vertices, paths along
/// edges, sources and pseudo-sources, watched points, and the loop that takes the nearest first. All distances are
/// those of the packed mesh, and so are the numbers of faces and vertices. The base has the members of MeshPropagation
/// (propagation.hpp) that do not depend on these lines: `seed`, `watched`, `run`, `answer`, `reached`.
///
/// `Step` is that of Labels, with a member `vertex` for a path along an edge from that vertex. A `Solver` derives from
/// VertexPropagation<Solver, Step>, so that calls are bound when it is compiled, and has
///
/// - `waiting()`: the queue, with `bool empty() const` and `void push_vertex(Index vertex, double distance)`;
/// - `void next()`: takes the nearest from the queue; a vertex goes to `emit`, a half-edge is for the solver;
/// - `void send_wedge(const Apex&, const PseudoSource& from, double to_end, Entry)`: lets all rays from a point of a
///   face wait beyond a half-edge of it, `apex.half_edge`, in whose frame the point is. `to_end` is the length of the
///   half-edge less from.x, told apart from 0 where rounding would not;
/// - `std::uint64_t carried() const`: how many lines it has carried across faces in this run;
/// - optionally `polled`, `ended`, `is_to_wait`, `along_edges_from`, `may_be_left_to`, `seed_face`,
///   `lowered_along_edge`, `lowered_straight` and `lowered_at_source` in place of those here.
template <class Solver, class Step>
class VertexPropagation {
 public:
  /// `run` polls for cancelling and a new limit once in so many steps.
  static constexpr std::size_t steps_a_poll = 256;

  /// Starts at a source. Its start distance is in the units of the packed mesh, its point has the face number of the
  /// mesh itself. Precondition: `begin`. O(1) and what waiting costs.
  void seed(const Source& source, Index number);

  /// Returns the points that `run` lowers, in ascending order of faces.
  std::vector<Watched>& watched() { return watched_; }
  const std::vector<Watched>& watched() const { return watched_; }

  /// Takes what waits, the nearest first, until nothing is left; nothing is sent on from beyond the limit that `begin`
  /// set. `lower_limit()` is called once in `steps_a_poll` steps, and its result becomes the limit if it is lower.
  /// Throws Cancelled if the user stops the run, NumericalError if lines multiply beyond `most_carried`.
  template <class LowerLimit>
  void run(const RunContext& context, LowerLimit&& lower_limit) {
    for (std::size_t step = 0; !solver().ended(); ++step) {
      if (step % steps_a_poll == 0) context.throw_if_cancelled(), refuse_to_explode();
      if (step % steps_a_poll == steps_a_poll - 1) limit_ = std::min(limit_, lower_limit()), solver().polled();
      solver().next();
    }
  }

  /// Returns the distance of a vertex, infinite where none was found.
  FoundDistance answer(Index vertex) const { return {labels_.distance(vertex), labels_[vertex].source}; }
  /// Returns the vertices that were reached, each once, in any order.
  const std::vector<Index>& reached() const { return labels_.touched(); }

 protected:
  explicit VertexPropagation(const PackedMesh& surface) : surface_(surface), labels_(surface.vertex_count()) {}
  ~VertexPropagation() = default;

  /// Forgets the last run: labels, watched points, limit. O(what it touched).
  void begin(bool keep, double limit);
  /// Is called now and then, for a solver that watches its run.
  void polled() {}
  /// Tells whether the run is over.
  bool ended() { return solver().waiting().empty(); }
  /// Returns the length of the path to a vertex that may go on along an edge, infinite if none may.
  double along_edges_from(Index vertex) const { return labels_.distance(vertex); }
  /// Tells whether a vertex that got this label is to wait in the queue.
  bool is_to_wait(Index vertex, const Label& label) {
    return label.corner == no_index || label.all_sides() || surface_.kind(vertex) != PackedMesh::VertexKind::smooth;
  }
  /// Tells whether a vertex goes on in place of an image that lies on it (`left_to_end`).
  bool may_be_left_to(Index /*vertex*/) const { return true; }
  /// Are called when a label was lowered by the path along an edge, by one straight from a source in a face, and by a
  /// source that is the vertex: for a solver whose answers are not the labels.
  void lowered_along_edge(Index /*vertex*/, Index /*from*/, double /*length*/) {}
  void lowered_straight(Index /*vertex*/, double /*distance*/, Index /*source*/) {}
  void lowered_at_source(Index /*vertex*/, double /*distance*/, Index /*source*/) {}

  /// Returns the number of the source that rays from this origin start at.
  Index source_of(Index origin) const {
    const auto vertices = static_cast<Index>(surface_.vertex_count());
    return origin < vertices ? labels_[origin].source : origin - vertices;
  }

  /// Sends rays from a vertex, as a pseudo-source, into all faces where a shortest path can go on. O(degree).
  void emit(Index vertex);
  /// Lowers the distance of the apex by the paths along the two edges at it.
  void lower_along_edges(const Apex& apex);
  /// Lowers the distance of the apex by a path of this length from a pseudo-source below its half-edge: straight if `x`
  /// is that of the pseudo-source, else bent at (x, 0). `step()` makes the step of that path.
  template <class MakeStep>
  void lower_apex_from(const Apex& apex, const PseudoSource& from, double x, double distance, MakeStep&& step);
  /// Calls `visit(watched, x, y)` for every watched point in the face of a half-edge, at (x, y) in the frame of that.
  template <class Visit>
  void for_each_watched(Index half_edge, Visit&& visit);
  /// Starts at a source in a face or on its edge: lowers the corners, and sends wedges through the edges that the
  /// source is not on.
  void seed_face(const SurfacePoint& at, const Source& source, Index number);

  /// Tells whether rays from an image below a half-edge that runs against `edge` are left to an end of the edge: it is
  /// in the place of the image, up to rounding. That vertex then emits to all sides instead of the image, whose rays
  /// would go round it without end.
  bool left_to_end(const PseudoSource& image, Index edge);

  /// Counts how often a vertex became a pseudo-source in this run.
  std::uint64_t emissions() const { return emissions_; }
  std::size_t bytes() const { return labels_.bytes() + watched_.capacity() * sizeof(Watched); }

  const PackedMesh& surface_;
  Labels<Step> labels_;
  std::vector<Watched> watched_;
  bool keep_ = false;
  double limit_ = 0;

 private:
  Solver& solver() { return static_cast<Solver&>(*this); }
  void refuse_to_explode();
  bool label_is_lower(Index vertex, double distance) const { return distance < labels_.distance(vertex); }
  void lower(Index vertex, const Label& label, const Step& step);
  void widen(Index vertex, double distance, double length);
  void emit_into(Index corner);

  std::vector<Index> emitting_;
  std::uint64_t emissions_ = 0;
};

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::begin(bool keep, double limit) {
  labels_.reset(keep);
  watched_.clear();
  keep_ = keep;
  limit_ = limit;
  emissions_ = 0;
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::refuse_to_explode() {
  const std::uint64_t faces = surface_.face_count(), most = most_carried(faces);
  if (solver().carried() <= most) return;
  throw NumericalError("the search carried more than " + std::to_string(most) + " straight lines across " +
                           std::to_string(faces) +
                           " faces: they multiply on this mesh, in which many faces meet at an edge",
                       "choose a solver that does not carry them, such as edge_dijkstra, or leave needless faces out");
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::lower(Index vertex, const Label& label, const Step& step) {
  labels_.set(vertex, label, step);
  if (solver().is_to_wait(vertex, label)) solver().waiting().push_vertex(vertex, label.distance);
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::lower_along_edges(const Apex& apex) {
  const double by_start = solver().along_edges_from(apex.start()) + apex.left_length();
  const double by_end = solver().along_edges_from(apex.end()) + apex.right_length();
  if (label_is_lower(apex.vertex(), by_start)) {
    lower(apex.vertex(), {by_start, {}, apex.left(), labels_[apex.start()].source}, {.vertex = apex.start()});
    solver().lowered_along_edge(apex.vertex(), apex.start(), apex.left_length());
  }
  if (label_is_lower(apex.vertex(), by_end)) {
    lower(apex.vertex(), {by_end, apex.angle(apex.c), apex.left(), labels_[apex.end()].source}, {.vertex = apex.end()});
    solver().lowered_along_edge(apex.vertex(), apex.end(), apex.right_length());
  }
}

template <class Solver, class Step>
template <class MakeStep>
void VertexPropagation<Solver, Step>::lower_apex_from(const Apex& apex, const PseudoSource& from, double x,
                                                      double distance, MakeStep&& step) {
  const Index vertex = apex.vertex();
  const bool all_sides = distance - from.sigma <= close_share * apex.length;  // two vertices in one place
  if (!label_is_lower(vertex, distance)) {
    if (all_sides) widen(vertex, distance, apex.length);
    return;
  }
  Angle side = all_sides ? no_angle : Angle{};
  if (!all_sides && surface_.kind(vertex) != PackedMesh::VertexKind::smooth) {
    const bool by_bend = x != from.x && std::hypot(x - apex.x, apex.y) > close_share * apex.length;
    side = by_bend ? apex.side(x - apex.x, -apex.y) : apex.side(from.x - apex.x, from.y - apex.y);
  }
  lower(vertex, {distance, side, apex.left(), source_of(from.origin)}, step());
}

/// Lets a vertex emit to all sides, and queues it again, if `distance` is about that of its label: which of the two is
/// the shorter is rounding. `distance` belongs to a path from a pseudo-source in the place of the vertex itself, up to
/// rounding; `length` is that of the half-edge it came through.
template <class Solver, class Step>
void VertexPropagation<Solver, Step>::widen(Index vertex, double distance, double length) {
  const double present = labels_.distance(vertex);
  if (labels_[vertex].all_sides() || distance > present + close_share * length) return;
  labels_.widen(vertex);
  solver().waiting().push_vertex(vertex, present);
}

template <class Solver, class Step>
bool VertexPropagation<Solver, Step>::left_to_end(const PseudoSource& image, Index edge) {
  const double length = surface_.length(edge), same_place = same_place_share * length;
  const bool at_end = std::abs(image.x) <= same_place, at_start = std::abs(image.x - length) <= same_place;
  if (-image.y > same_place || !(at_end || at_start)) return false;
  const Index vertex = surface_.from(at_end ? SurfaceMesh::next(edge) : edge);
  if (!solver().may_be_left_to(vertex)) return false;
  if (labels_.distance(vertex) > image.sigma * (1 + rounding_share) + 4 * same_place) return false;
  widen(vertex, image.sigma, length);
  return true;
}

template <class Solver, class Step>
template <class Visit>
void VertexPropagation<Solver, Step>::for_each_watched(Index half_edge, Visit&& visit) {
  const Index face = half_edge / 3;
  auto it =
      std::lower_bound(watched_.begin(), watched_.end(), face, [](const Watched& w, Index f) { return w.at.face < f; });
  for (; it != watched_.end() && it->at.face == face; ++it) {
    const auto [x, y] = surface_.in_frame(half_edge, it->at.b);
    visit(*it, x, y);
  }
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::emit(Index vertex) {
  const Label label = labels_[vertex];
  if (label.distance > limit_) return;
  corners_that_emit(surface_, vertex, label, emitting_);
  emissions_ += !emitting_.empty();
  for (const Index corner : emitting_)
    if (!surface_.is_copy(corner / 3)) emit_into(corner);
}

/// Sends a wedge from the vertex at which `corner` starts to the opposite edge, and lowers the ends of the two edges at
/// it.
template <class Solver, class Step>
void VertexPropagation<Solver, Step>::emit_into(Index corner) {
  const Apex apex(surface_, SurfaceMesh::next(corner));  // its apex is the vertex
  const Index vertex = apex.vertex();
  const Label label = labels_[vertex];
  const double by_left = label.distance + apex.left_length(), by_right = label.distance + apex.right_length();
  if (label_is_lower(apex.start(), by_left)) {
    lower(apex.start(), {by_left, apex.angle(apex.a), apex.half_edge, label.source}, {.vertex = vertex});
    solver().lowered_along_edge(apex.start(), vertex, apex.left_length());
  }
  if (label_is_lower(apex.end(), by_right)) {
    lower(apex.end(), {by_right, {}, apex.right(), label.source}, {.vertex = vertex});
    solver().lowered_along_edge(apex.end(), vertex, apex.right_length());
  }
  const double to_end = apex.right_length() * apex.face.cosine[apex.b];
  solver().send_wedge(apex, {apex.x, apex.y, label.distance, vertex}, to_end, Entry::apex);
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::seed(const Source& source, Index number) {
  const SurfacePoint at = surface_.inner(source.at);
  for (int i = 0; i < 3; ++i) {
    if (at.b[i] != 1) continue;
    const Index vertex = surface_.face(at.face).vertex[i];
    if (!label_is_lower(vertex, source.start)) return;
    lower(vertex, {source.start, {}, no_index, number}, {});
    solver().lowered_at_source(vertex, source.start, number);
    return;
  }
  surface_.for_each_name(at, [&](const SurfacePoint& here) { solver().seed_face(here, source, number); });
}

template <class Solver, class Step>
void VertexPropagation<Solver, Step>::seed_face(const SurfacePoint& at, const Source& source, Index number) {
  const Index origin = static_cast<Index>(surface_.vertex_count()) + number;
  for (int i = 0; i < 3; ++i) {
    const Apex apex(surface_, 3 * at.face + static_cast<Index>(i));
    const auto [x, y] = surface_.in_frame(apex.half_edge, at.b);
    const double distance = source.start + std::sqrt(x * x + y * y);
    if (label_is_lower(apex.start(), distance)) {
      lower(apex.start(), {distance, angle_of(x, y), apex.half_edge, number}, {});
      solver().lowered_straight(apex.start(), distance, number);
    }
    if (at.b[apex.c] == 0) continue;
    const double to_end = at.b[apex.a] * apex.length + at.b[apex.c] * apex.right_length() * apex.face.cosine[apex.b];
    solver().send_wedge(apex, {x, y, source.start, origin}, to_end, Entry::loose);
  }
}

}  // namespace geodrome
