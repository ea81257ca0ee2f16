// SPDX-License-Identifier: MIT
#include "engine/input/ear_clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// The grid is exact, but corners that should lie on a line are off it by rounding. So an ear should be no sliver, and
// its third edge should pass no corner closer than rounding; where no such ear is left, any ear will do.
namespace geodrome::input {
namespace {

constexpr double rounding = 1e-12;
constexpr double sliver = 1e-12;         // doubled area over the longest edge squared
constexpr std::int64_t near = 1 << 14;   // on the grid, more than that rounding
constexpr double clearly_better = 1e-9;  // what is no tie that rounding decides

double length(const PlanePoint& a, const PlanePoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

double doubled_area(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarClipper {
 public:
  EarClipper(std::span<const GridPoint> walk, std::span<const PlanePoint> plane)
      : at_(walk), plane_(plane), shape_(walk.size(), unknown) {
    for (std::size_t i = 0; i < walk.size(); ++i) {
      next_.push_back((i + 1) % walk.size());
      previous_.push_back((i + walk.size() - 1) % walk.size());
    }
  }

  std::optional<std::vector<std::array<std::size_t, 3>>> triangles() {
    for (std::size_t left = at_.size(); left > 2; --left) {
      const std::size_t ear = left == 3 ? start_ : best_ear();
      const GridPoint &a = at_[previous_[ear]], &b = at_[ear], &c = at_[next_[ear]];
      const WideInteger area = doubled_area(a, b, c);
      if (area < 0 || (area == 0 && a != b && b != c && c != a)) return std::nullopt;
      clip(ear);
    }
    return std::move(triangles_);
  }

 private:
  static constexpr double unknown = -1, none = 0;

  void clip(std::size_t ear) {
    const std::size_t before = previous_[ear], after = next_[ear];
    triangles_.push_back({before, ear, after});
    next_[before] = after, previous_[after] = before;
    shape_[before] = shape_[after] = unknown;
    if (ear == start_) start_ = after;
  }

  /// The best ear; a strict one if there is one, else any, else an edge without length.
  std::size_t best_ear() {
    if (const auto found = best_known()) return *found;
    std::ranges::fill(shape_, unknown);
    strict_ = false;
    if (const auto found = best_known()) return *found;
    std::size_t corner = start_;
    while (at_[corner] != at_[next_[corner]] && next_[corner] != start_) corner = next_[corner];
    return corner;
  }

  std::optional<std::size_t> best_known() {
    std::optional<std::size_t> best;
    std::size_t corner = start_;
    do {
      if (shape_[corner] == unknown) shape_[corner] = shape_of_ear(corner);
      if (shape_[corner] > (best ? shape_[*best] * (1 + clearly_better) : none)) best = corner;
      corner = next_[corner];
    } while (corner != start_);
    return best;
  }

  /// Doubled area over the longest edge squared if the corner is an ear, else `none`.
  double shape_of_ear(std::size_t corner) const {
    const std::size_t a = previous_[corner], c = next_[corner];
    if (doubled_area(at_[a], at_[corner], at_[c]) <= 0) return none;
    const PlanePoint &p = plane_[a], &q = plane_[corner], &r = plane_[c];
    const double longest = std::max({length(p, q), length(q, r), length(r, p)});
    const double shape = doubled_area(p, q, r) / (longest * longest);
    if (strict_ && !(shape > sliver)) return none;
    const auto [west, east] = std::minmax({at_[a].x, at_[corner].x, at_[c].x});
    const auto [south, north] = std::minmax({at_[a].y, at_[corner].y, at_[c].y});
    for (std::size_t i = next_[c]; i != a; i = next_[i]) {
      const GridPoint& at = at_[i];
      if (at.x < west - near || at.x > east + near || at.y < south - near || at.y > north + near) continue;
      if (at != at_[a] && at != at_[corner] && at != at_[c] && blocks(i, {a, corner, c})) return none;
    }
    return std::max(shape, std::numeric_limits<double>::min());
  }

  /// The corner `i` lies in the triangle or on its border, or within rounding of it.
  bool blocks(std::size_t i, const std::array<std::size_t, 3>& triangle) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = triangle[k], to = triangle[(k + 1) % 3];
      if (doubled_area(at_[from], at_[to], at_[i]) >= 0) continue;
      const PlanePoint &p = plane_[from], &q = plane_[to];
      if (!strict_ || doubled_area(p, q, plane_[i]) < -rounding * length(p, q)) return false;
    }
    return true;
  }

  const std::span<const GridPoint> at_;
  const std::span<const PlanePoint> plane_;
  std::vector<std::size_t> next_, previous_;
  std::vector<double> shape_;  // of each corner's ear, as far as it is known
  std::size_t start_ = 0;
  bool strict_ = true;  // slivers, and edges that pass corners closer than rounding, are avoided
  std::vector<std::array<std::size_t, 3>> triangles_;
};

}  // namespace

std::optional<std::vector<std::array<std::size_t, 3>>> clip_ears(std::span<const GridPoint> walk,
                                                                 std::span<const PlanePoint> plane) {
  return EarClipper(walk, plane).triangles();
}

}  // namespace geodrome::input
