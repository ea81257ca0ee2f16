// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "plugins/solver_schreiber/front.hpp"
#include "tests/plugins/common/window_scenes.hpp"

/// Wavefronts over a half-edge, and what is true of them: by the ways of windows, places that no ray has to tell.
namespace geodrome::schreiber::test {

using chen_han::Window;
using chen_han::test::Entered;
using chen_han::test::ParentAndChild;
using chen_han::test::Place;
using chen_han::test::power;
using chen_han::test::random_parent_and_child;
using chen_han::test::random_scene;
using chen_han::test::sample_places;
using chen_han::test::Scene;
using shapes::Random;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// With rays to two places of the half-edge; an image at one of them has its ray along the half-edge.
inline Generator generator_of(const Window& w) {
  Generator g{w.x, w.y, w.sigma, -1, 0, 1, 0, infinity, w.origin};
  g.set_low(w.low, 0), g.set_high(w.high, 0);
  return g;
}

/// Where the line from the image to a point on or above the half-edge crosses it.
inline double crossing(const Window& w, double px, double py) {
  return py > 0 ? w.x + (px - w.x) * (w.y / (w.y - py)) : px;
}
inline bool has_line(const Window& w, double px, double py) {
  const double x = crossing(w, px, py);
  return w.low <= x && x <= w.high;
}
/// Length of the straight way of a window, infinite if it has none; and of the one that bends at an end of it.
inline double straight(const Window& w, double px, double py) { return has_line(w, px, py) ? w.to(px, py) : infinity; }
inline double bent(const Window& w, double px, double py) {
  const auto over = [&](double x) { return w.at(x) + std::hypot(px - x, py); };
  return std::min(over(w.low), over(w.high));
}

struct Truth {
  double straight = infinity, bent = infinity;
  std::size_t nearest = 0;
  /// Whether the nearest way is straight, by more than rounding; only then something must be known of it.
  bool is_clear() const { return std::isfinite(straight) && straight * (1 + 1e-12) < bent; }
};
inline Truth truth(std::span<const Window> windows, double px, double py) {
  Truth t;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const double way = straight(windows[i], px, py);
    if (way < t.straight) t.straight = way, t.nearest = i;
    if (!std::isfinite(way)) t.bent = std::min(t.bent, bent(windows[i], px, py));
  }
  return t;
}

/// The nearest of a front's generators that have a ray to a point.
inline double nearest_covering(const Front& front, double px, double py) {
  double least = infinity;
  front.for_each([&](const Generator& g) {
    if (g.covers(px, py)) least = std::min(least, g.to(px, py));
  });
  return least;
}

/// Images below a half-edge of `length` that are about equally far, with all of it or some.
inline std::vector<Window> random_windows(Random& random, std::size_t count, double length, double spread, bool whole) {
  std::vector<Window> windows;
  for (std::size_t i = 0; i < count; ++i) {
    Window w{length * random.uniform(-1, 2), -length * power(random, 1e-2, 2), 0, 0, length, static_cast<Index>(i), 0};
    w.sigma = 5 + length * spread * random.uniform() - std::hypot(w.x - length * random.uniform(), w.y);
    if (!whole) {
      const double a = length * random.uniform(), b = length * random.uniform();
      w.low = std::min(a, b), w.high = std::max(a, b);
    }
    windows.push_back(w);
  }
  return windows;
}
/// Many images close below a half-edge, of which a large part has some of it.
inline std::vector<Window> many_windows(Random& random, std::size_t count, double length) {
  std::vector<Window> windows;
  const double spacing = length / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i)
    windows.push_back({length * random.uniform(), -length * 0.01 * random.uniform(1, 2), 5 + spacing * random.uniform(),
                       0, length, static_cast<Index>(i), 0});
  return windows;
}

/// The lower envelope of windows, merged one by one.
inline Front envelope(FrontEditor& editor, FrontPool& pool, std::span<const Window> windows, double length) {
  Front front(pool);
  for (const Window& w : windows) editor.merge(front, Front(pool, generator_of(w)), length);
  return front;
}

/// An edge of the face above a half-edge, from `start` to `end`.
struct NextEdge {
  Place start, end;

  bool is_left() const { return start.y == 0; }
  Place apex() const { return is_left() ? end : start; }
  double length() const { return std::hypot(end.x - start.x, end.y - start.y); }
  Place at(double place) const {
    const double t = place / length();
    return {start.x + t * (end.x - start.x), start.y + t * (end.y - start.y)};
  }
  /// To its frame, in which what comes from the half-edge is below it.
  Motion motion() const {
    const double c = (end.x - start.x) / length(), s = (end.y - start.y) / length();
    return {c, -s, -(c * start.x + s * start.y), s * start.x - c * start.y};
  }
};
inline NextEdge random_next_edge(Random& random, double length) {
  const Place apex{length * random.uniform(-0.5, 1.5), length * power(random, 1e-2, 2)};
  return random.uniform() < 0.5 ? NextEdge{{0, 0}, apex} : NextEdge{apex, {length, 0}};
}

}  // namespace geodrome::schreiber::test
