// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/direct_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <unordered_set>
#include <utility>

namespace geodrome::aleksandrov {
namespace {

/// Turns around a vertex from a place, face by face. Each face is seen in the frame of the leg it was entered by: the
/// vertex at the origin, the leg along x, the face above; mirrored where that runs clockwise.
///
/// The less a way turns the shorter it is, so the least turn to each leg is enough: Dijkstra's search, up to half a
/// turn.
class Turn {
 public:
  Turn(const SteinerGraph& graph, const SurfacePoint& to, DirectWay& best) : graph_(graph), to_(to), best_(best) {}

  /// All ways around the start of half-edge `corner`, from a place in its frame.
  void around(Index corner, Point2 from) {
    entries_.clear(), reached_.clear(), queue_ = {};
    leave(corner, true, {from.x, -from.y}, no_index);
    Point2 over = rotated(corner, from, -1);
    over.y = std::min(over.y, 0.0);  // on that leg rounding may put it beyond
    leave(SurfaceMesh::previous(corner), false, over, no_index);
    while (!queue_.empty()) {
      const Leg leg = queue_.top();
      queue_.pop();
      if (!reached_.contains(end_of(leg.h, leg.h_starts))) enter_faces(leg);
    }
  }

 private:
  /// An edge at the vertex that a face is left through.
  struct Leg {
    double turn;  ///< from the beginning, in radians
    Index h;
    bool h_starts;   ///< at the vertex, or ends there
    Point2 from;     ///< the beginning, in the frame of the leg
    Index previous;  ///< the entry into the face that is left, or none

    friend bool operator<(const Leg& a, const Leg& b) { return std::pair(b.turn, b.h) < std::pair(a.turn, a.h); }
  };
  /// Into a face, through a leg.
  struct Entry {
    Leg leg;
    Index g;
    bool g_starts;
    Index corner;  ///< of the face entered
  };

  static std::uint64_t end_of(Index h, bool starts) { return 2 * std::uint64_t{h} + starts; }

  /// Turned by the angle at a corner, counterclockwise for sign 1.
  Point2 rotated(Index corner, Point2 p, int sign) const {
    const auto& c = graph_.corner(corner);
    const double cosine = c.cosine * c.cosine - c.sine * c.sine, sine = sign * 2 * c.cosine * c.sine;
    return {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  }

  void leave(Index h, bool h_starts, Point2 from, Index previous) {
    if (from.y <= 0) queue_.push({std::atan2(-from.y, from.x), h, h_starts, from, previous});
  }

  void enter_faces(const Leg& leg) {
    reached_.insert(end_of(leg.h, leg.h_starts));
    for (Index g = graph_.corner(leg.h).next_on_edge; g != leg.h; g = graph_.corner(g).next_on_edge) {
      const bool g_starts = leg.h_starts == (graph_.corner(g).forward == graph_.corner(leg.h).forward);
      const Index corner = g_starts ? g : SurfaceMesh::next(g), entry = static_cast<Index>(entries_.size());
      reached_.insert(end_of(g, g_starts));
      entries_.push_back({leg, g, g_starts, corner});
      if (g / 3 == to_.face) look(entry);
      leave(g_starts ? SurfaceMesh::previous(g) : corner, !g_starts, rotated(corner, leg.from, -1), entry);
    }
  }

  /// Is the straight way to the place in the face that was entered within the faces?
  void look(Index last) {
    const Entry& end = entries_[last];
    Point2 to = graph_.in_frame(end.g, to_.b);
    if (!end.g_starts) to.x = graph_.corner(end.g).length - to.x;
    const double distance = length(to - end.leg.from);
    if (!(distance < best_.distance)) return;
    std::vector<DirectWay::Crossing> crossings;
    for (Index i = last; i != no_index; i = entries_[i].leg.previous) {
      if (i != last) to = rotated(entries_[i].corner, to, 1);
      const auto& [leg, g, g_starts, corner] = entries_[i];
      const double rise = to.y - leg.from.y, whole = graph_.corner(leg.h).length;
      const double x = rise > 0 ? (leg.from.x * to.y - to.x * leg.from.y) / rise : to.x;
      if (!(x >= 0 && x <= whole)) return;
      crossings.push_back({leg.h, g, leg.h_starts ? x : whole - x});
    }
    std::reverse(crossings.begin(), crossings.end());
    best_ = {distance, std::move(crossings)};
  }

  const SteinerGraph& graph_;
  const SurfacePoint& to_;
  DirectWay& best_;
  std::vector<Entry> entries_;
  std::unordered_set<std::uint64_t> reached_;  ///< ends of half-edges, all of a leg
  std::priority_queue<Leg> queue_;
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
