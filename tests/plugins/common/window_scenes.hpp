// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_chen_han/windows.hpp"
#include "tools/shapes/random.hpp"

/// Windows in the order in which their lines enter the face below a half-edge, made as a surface makes them.
namespace geodrome::chen_han::test {

using shapes::Random;

struct Place {
  double x, y;
};
inline double apart(const Place& p, const Place& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// A window, and the part of the border of the face below through which its lines enter: the end nearer to the start of
/// the half-edge along that border comes first.
struct Entered {
  Window window;
  Place first, second;

  /// The shortest way to (x, 0) that bends where it enters; infinite if a straight line goes there.
  double bent(double x) const {
    if (window.low <= x && x <= window.high) return std::numeric_limits<double>::infinity();
    const Place end = x < window.low ? first : second;
    return window.to(end.x, end.y) + apart(end, {x, 0});
  }
};

/// The face below: from start (0, 0) and end (length, 0) of the half-edge down to (corner.x, corner.y). Its windows
/// enter through the edge at the start, from the corner, through the edge at the end, one beside the other: `origin` is
/// a window's number in this order.
struct Scene {
  double length;
  Place corner;
  std::vector<Entered> windows;
  std::size_t left_end = 0, right_begin = 0;  ///< the ones between them come from the corner

  /// Each of up to as many cuts, one after the other, may take an `equal_share` too much.
  double noise() const { return static_cast<double>(windows.size() + 1) * equal_share; }
};

inline double power(Random& random, double low, double high) {
  return std::exp(random.uniform(std::log(low), std::log(high)));
}

/// Where the line from the image through p meets the half-edge; `away` if it never climbs to it.
inline double met(const Place& image, const Place& p, double away, double length) {
  if (!(p.y > image.y)) return away;
  return std::clamp(p.x + (p.x - image.x) * (-p.y / (p.y - image.y)), 0.0, length);
}

/// An image on the other side of the edge from p to q than `inside`, not above the half-edge; some graze it, some are
/// close to the edge.
inline Place random_image(const Place& p, const Place& q, const Place& inside, Random& random) {
  const double dx = q.x - p.x, dy = q.y - p.y, size = std::hypot(dx, dy);
  const double side = dx * (inside.y - p.y) - dy * (inside.x - p.x) > 0 ? -1 : 1;
  const double at = random.uniform();
  for (int attempt = 0; attempt < 50; ++attempt) {
    const double turn = random.uniform(-1.5, 1.5), away = power(random, 1e-3, 3);
    const double out = side * std::cos(turn) / size, along = std::sin(turn) / size;
    Place image{p.x + at * dx + away * (along * dx - out * dy), p.y + at * dy + away * (along * dy + out * dx)};
    if (random.uniform() < 0.05) image.y = -power(random, 1e-15, 1e-3);
    const double beyond = side * (dx * (image.y - p.y) - dy * (image.x - p.x));
    if (image.y <= 0 && beyond > 0) return image;
  }
  return {(p.x + q.x) / 2, (p.y + q.y) / 2};
}

/// Adds the window that enters through the part [first, second] of an edge; `spread` is how much it may be farther than
/// others there, `away` where the end of one goes whose line never meets the half-edge.
inline void add_window(Scene& scene, const Place& image, const Place& first, const Place& second, double away,
                       double spread, Random& random) {
  const Place middle{(first.x + second.x) / 2, (first.y + second.y) / 2};
  Window w{image.x, image.y, 5 + spread * random.uniform() - apart(image, middle), 0, 0, 0, no_index};
  w.low = met(image, first, away, scene.length), w.high = met(image, second, away, scene.length);
  if (!(w.low < w.high) && random.uniform() < 0.7) return;  // empty ones come along now and then
  w.origin = static_cast<Index>(scene.windows.size());
  scene.windows.push_back({w, first, second});
}

/// Up to `most` windows through the edge from `from` to `to`, which touch or have gaps between them; now and then one
/// image has several.
inline void add_side(Scene& scene, const Place& from, const Place& to, std::size_t most, double away, double spread,
                     Random& random) {
  std::vector<double> ends(2 * random.index(most + 1));
  for (double& end : ends) end = random.uniform();
  std::sort(ends.begin(), ends.end());
  if (!ends.empty() && random.uniform() < 0.5) ends.front() = 0;
  if (!ends.empty() && random.uniform() < 0.5) ends.back() = 1;
  const Place inside{(scene.length + scene.corner.x) / 3, scene.corner.y / 3};
  const bool touch = random.uniform() < 0.5;
  const auto on_edge = [&](double t) { return Place{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}; };
  Place image{};
  for (std::size_t i = 0; i + 1 < ends.size(); i += touch ? 1 : 2) {
    if (i == 0 || random.uniform() < 0.9) image = random_image(from, to, inside, random);
    add_window(scene, image, on_edge(ends[i]), on_edge(ends[i + 1]), away, spread, random);
  }
}

/// A face below of any shape with up to `most` windows through either edge. Every other time a path bends at the
/// corner: the window from it lies on a ray with its parent.
inline Scene random_scene(Random& random, std::size_t most) {
  Scene scene{power(random, 0.1, 2), {}, {}};
  scene.corner = {random.uniform(-1, scene.length + 1), -power(random, 1e-3, 2)};
  const double spread = random.uniform() < 0.3 ? 0 : power(random, 1e-6, 3);
  add_side(scene, {0, 0}, scene.corner, most, scene.length, spread, random);
  scene.left_end = scene.windows.size();
  if (random.uniform() < 0.5) {
    const auto [x, y] = scene.corner;
    double sigma = 5 + spread * random.uniform();
    if (!scene.windows.empty() && random.uniform() < 0.5) sigma = scene.windows.back().window.to(x, y);
    scene.windows.push_back(
        {{x, y, sigma, 0, scene.length, static_cast<Index>(scene.left_end), no_index}, scene.corner, scene.corner});
  }
  scene.right_begin = scene.windows.size();
  add_side(scene, scene.corner, {scene.length, 0}, most, 0, spread, random);
  return scene;
}

/// The length of a half-edge where any would do.
inline constexpr double usual_length = 1.5;

/// An image at about `distance` from the half-edge's middle, whose own height is anything, nothing too.
inline Window random_window(double distance, double spread, Random& random) {
  const double y = random.uniform() < 0.1 ? 0 : -power(random, 1e-14, 2);
  Window w{random.uniform(-1, usual_length + 1), y, 0, 0, usual_length, 0, no_index};
  w.sigma = std::max(0.0, distance + spread * random.uniform() - w.at(usual_length / 2));
  return w;
}

/// A pseudo-source and one behind it, on the left, which part at `place`, where their common ray meets the half-edge.
struct ParentAndChild {
  Window parent, child;
  double place;
};
inline ParentAndChild random_parent_and_child(Random& random) {
  const double place = random.uniform(0.2, 0.8), share = random.uniform(0.1, 0.9);
  const Window parent{random.uniform(-1, 2), -random.uniform(0.5, 1), random.uniform(0, 5), 0, place, 0, 0};
  Window child{parent.x + share * (place - parent.x), parent.y * (1 - share), 0, place, 1, 1, 0};
  child.sigma = parent.to(child.x, child.y);
  return {parent, child, place};
}

/// One place within each part into which the ends of windows cut the half-edge, and some more. Parts narrower than
/// 1e-9 of it are left out: there the rounding of a place counts for more than that of a distance.
inline std::vector<double> sample_places(double length, std::vector<double> ends, Random& random) {
  ends.push_back(0), ends.push_back(length);
  std::sort(ends.begin(), ends.end());
  std::vector<double> places;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    if (ends[i + 1] - ends[i] > 1e-9 * length) places.push_back(ends[i] + (ends[i + 1] - ends[i]) / 2);
  for (int i = 0; i < 10; ++i) places.push_back(random.uniform(0, length));
  return places;
}

inline bool covers(const Window& w, double x) { return w.low <= x && x <= w.high; }

/// The nearest of the windows that have a line to (x, 0); infinite if none has.
inline double nearest(const std::vector<Window>& windows, double x) {
  double least = std::numeric_limits<double>::infinity();
  for (const Window& w : windows)
    if (covers(w, x)) least = std::min(least, w.at(x));
  return least;
}

/// The first `count` windows of the arrays.
inline std::vector<Window> listed(const WindowArrays& windows, std::size_t count) {
  std::vector<Window> result;
  for (std::size_t i = 0; i < count; ++i) result.push_back(windows.get(i));
  return result;
}

/// Whether the windows have width and none begins before the one before it ends.
inline bool in_order(const std::vector<Window>& windows) {
  for (std::size_t i = 0; i < windows.size(); ++i)
    if (!(windows[i].low < windows[i].high) || (i > 0 && windows[i].low < windows[i - 1].high)) return false;
  return true;
}

}  // namespace geodrome::chen_han::test
