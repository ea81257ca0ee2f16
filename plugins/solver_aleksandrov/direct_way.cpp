// SPDX-License-Identifier: MIT
#include "solver_aleksandrov/direct_way.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::aleksandrov {
namespace {

/// Turns around a vertex from a place, face by face. Each face is seen in the frame of the leg it was entered by: the
/// vertex at the origin, the leg along x, the face above; mirrored where that runs clockwise.
class Turn {
 public:
  Turn(const SteinerGraph& graph, const SurfacePoint& to, DirectWay& best) : graph_(graph), to_(to), best_(best) {}

  /// Both ways around the start of half-edge `corner`, from a place in its frame.
  void around(Index corner, Point2 from) {
    vertex_ = graph_.corner(corner).vertex;
    faces_left_ = graph_.corners_at(vertex_).size();
    leave(corner, true, {from.x, -from.y});
    Point2 over = rotated(corner, from, -1);
    over.y = std::min(over.y, 0.0);  // on that leg rounding may put it beyond
    leave(SurfaceMesh::previous(corner), false, over);
  }

 private:
  struct Leg {
    Index h, g;     ///< left through, entered by
    bool g_starts;  ///< at the vertex
    Point2 from;    ///< the beginning, in the frame of the leg
    Index corner;   ///< of the face entered
  };

  /// Turned by the angle at a corner, counterclockwise for sign 1.
  Point2 rotated(Index corner, Point2 p, int sign) const {
    const auto& c = graph_.corner(corner);
    const double cosine = c.cosine * c.cosine - c.sine * c.sine, sine = sign * 2 * c.cosine * c.sine;
    return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  }

  /// Through leg `h`, which starts at the vertex or ends there; `from` is in the frame of the leg.
  void leave(Index h, bool h_starts, Point2 from) {
    if (faces_left_ == 0 || from.y > 0) return;
    --faces_left_;
    for (Index g = graph_.corner(h).next_on_edge; g != h; g = graph_.corner(g).next_on_edge) {
      const bool g_starts = h_starts == (graph_.corner(g).forward == graph_.corner(h).forward);
      const Index corner = g_starts ? g : SurfaceMesh::next(g);
      legs_.push_back({h, g, g_starts, from, corner});
      look();
      leave(g_starts ? SurfaceMesh::previous(g) : corner, !g_starts, rotated(corner, from, -1));
      legs_.pop_back();
    }
    ++faces_left_;
  }

  /// Is the place looked for in the face that was entered, and is the straight way there within the faces?
  void look() {
    const Leg& last = legs_.back();
    if (last.g / 3 != to_.face) return;
    Point2 to = graph_.in_frame(last.g, to_.b);
    if (!last.g_starts) to.x = graph_.corner(last.g).length - to.x;
    const double distance = length(to - last.from);
    if (!(distance < best_.distance)) return;
    std::vector<DirectWay::Crossing> crossings(legs_.size());
    for (std::size_t i = legs_.size(); i-- > 0;) {
      const Leg& leg = legs_[i];
      const double rise = to.y - leg.from.y, whole = graph_.corner(leg.h).length;
      const double x = rise > 0 ? (leg.from.x * to.y - to.x * leg.from.y) / rise : to.x;
      if (!(x >= 0 && x <= whole)) return;
      const bool h_starts = leg.g_starts == (graph_.corner(leg.g).forward == graph_.corner(leg.h).forward);
      crossings[i] = {leg.h, leg.g, h_starts ? x : whole - x};
      if (i > 0) to = rotated(legs_[i - 1].corner, to, 1);
    }
    best_ = {distance, std::move(crossings)};
  }

  const SteinerGraph& graph_;
  const SurfacePoint& to_;
  DirectWay& best_;
  Index vertex_ = no_index;
  std::size_t faces_left_ = 0;
  std::vector<Leg> legs_;
};

}  // namespace

DirectWay direct_way(const SteinerGraph& graph, const SurfacePoint& from, const SurfacePoint& to) {
  DirectWay best;
  if (from.face == to.face)
    best.distance = length(graph.in_frame(3 * from.face, from.b) - graph.in_frame(3 * from.face, to.b));
  Turn turn(graph, to, best);
  for (Index h = 3 * from.face; h < 3 * from.face + 3; ++h)
    for (Index k = 3 * to.face; k < 3 * to.face + 3; ++k)
      if (graph.corner(h).vertex == graph.corner(k).vertex) {
        turn.around(h, graph.in_frame(h, from.b));
        break;
      }
  return best;
}

}  // namespace geodrome::aleksandrov
