// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/joint.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "geodrome/errors.hpp"

namespace geodrome::aleksandrov {
namespace {

/// What rounding may be between two names of one place; about 1 is the mean edge, and longer edges round more.
constexpr double close = 1e-10;
/// A way through one face less may be so much farther off: no more than the rounding of lengths.
constexpr double price_of_a_face = 1e-15;

/// Goes from face to face over edges and vertices that are within rounding of a place: Dijkstra's search, by how far
/// the place is moved.
class Walk {
 public:
  Walk(const PackedMesh& surface, const SurfacePoint& at)
      : surface_(surface), limit_(close * std::max(1.0, surface.longest_side(at.face))) {
    step({at, 0, no_index});
  }

  /// The place in `face`, or no_index if nothing leads there.
  Index to(Index face) {
    while (!queue_.empty()) {
      const Index from = queue_.top().second;
      queue_.pop();
      const Index here = steps_[from].at.face;
      if (here == face) return from;
      if (std::find(done_.begin(), done_.end(), here) != done_.end()) continue;
      done_.push_back(here);
      for (Index h = 3 * here; h < 3 * here + 3; ++h) over_edge(from, h), over_vertex(from, h);
    }
    return no_index;
  }

  std::vector<SurfacePoint> points_to(Index last) const {
    std::vector<SurfacePoint> points;
    for (; steps_[last].previous != no_index; last = steps_[last].previous) points.push_back(steps_[last].at);
    std::reverse(points.begin(), points.end());
    return points;
  }

 private:
  struct Step {
    SurfacePoint at;  ///< in the face that was entered
    double moved;
    Index previous;
  };

  void step(const Step& next) {
    queue_.emplace(next.moved, static_cast<Index>(steps_.size()));
    steps_.push_back(next);
  }

  void over_edge(Index from, Index h) {
    const auto [x, y] = surface_.in_frame(h, steps_[from].at.b);
    const double length = surface_.length(h), on = std::clamp(x, 0.0, length), off = std::hypot(x - on, y);
    if (!(off <= limit_)) return;
    const double moved = steps_[from].moved + off + price_of_a_face;
    surface_.for_each_across(h, [&](Index g, bool mirrored) {
      step({surface_.point_on(g, mirrored ? on : length - on), moved, from});
    });
  }

  void over_vertex(Index from, Index h) {
    const auto [x, y] = surface_.in_frame(h, steps_[from].at.b);
    if (!(std::hypot(x, y) <= limit_)) return;
    const double moved = steps_[from].moved + std::hypot(x, y) + price_of_a_face;
    for (const Index g : surface_.corners(surface_.from(h))) step({surface_.point_on(g, 0), moved, from});
  }

  const PackedMesh& surface_;
  double limit_;
  std::vector<Step> steps_;
  std::vector<Index> done_;
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<SurfacePoint> joint(const PackedMesh& surface, const SurfacePoint& at, Index face) {
  Walk walk(surface, at);
  const Index last = walk.to(face);
  if (last == no_index)
    throw NumericalError("a path could not be traced from face " + std::to_string(surface.original_face(at.face)) +
                             " to face " + std::to_string(surface.original_face(face)) +
                             ": rounding has put a point of it away from the edge that it crosses",
                         "remove faces that are thinner than rounding, or use an exact solver");
  return walk.points_to(last);
}

}  // namespace geodrome::aleksandrov
