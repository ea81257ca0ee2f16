// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/torus_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "geodrome/errors.hpp"
#include "tools/bench/shapes/torus_rays.hpp"

namespace geodrome::bench {
namespace {

constexpr double pi = std::numbers::pi;

/// In [0, 2 pi).
double turn(double angle) {
  const double reduced = angle - 2 * pi * std::floor(angle / (2 * pi));
  return reduced < 2 * pi ? reduced : 0;
}

double angle_between(double a, double b) {
  const double one_way = turn(a - b);
  return std::min(one_way, 2 * pi - one_way);
}

/// The length of the best of three paths: along the circle of latitude of either point, or on the inner equator; the
/// rest on meridians.
double upper_bound(double v, const TorusPoint& target) {
  const auto by_circle = [&](double circle) {
    const double radius = torus_ring + torus_tube * std::cos(circle);
    return radius * target.u + torus_tube * (angle_between(v, circle) + angle_between(circle, target.v));
  };
  return std::min({by_circle(v), by_circle(target.v), by_circle(pi)});
}

/// Targets by their angles, so that those near a cell are found. The source is at u = 0, and u is from 0 to pi: the
/// torus is its own mirror image, and no shortest path goes farther round than pi (mirrored at u = pi it would end at
/// the mirror image of its end, with a kink).
class TargetBins {
 public:
  TargetBins(const TorusPoint& source, std::span<const TorusPoint> targets) {
    side_ = std::max<std::size_t>(8, static_cast<std::size_t>(std::sqrt(static_cast<double>(targets.size()))));
    bins_.resize(side_ * side_);
    for (const TorusPoint& t : targets) {
      const TorusPoint folded{angle_between(t.u, source.u), turn(t.v)};
      bins_[column(folded.u) * side_ + row(folded.v)].push_back(static_cast<Index>(points_.size()));
      points_.push_back(folded);
    }
  }

  const TorusPoint& point(Index i) const { return points_[i]; }
  std::size_t size() const { return points_.size(); }

  /// Calls `function` with every target whose bin meets the box; v may be any number of turns.
  template <class Function>
  void visit(double u_low, double u_high, double v_low, double v_high, Function&& function) const {
    if (u_low > pi || u_high < 0) return;
    const std::size_t first = column(std::max(u_low, 0.0)), last = column(std::min(u_high, pi));
    const double bin = 2 * pi / static_cast<double>(side_);
    const auto bottom = static_cast<long>(std::floor(v_low / bin));
    const long count = std::min(static_cast<long>(std::floor(v_high / bin)) - bottom + 1, static_cast<long>(side_));
    const long start = (bottom % static_cast<long>(side_) + static_cast<long>(side_)) % static_cast<long>(side_);
    for (std::size_t c = first; c <= last; ++c)
      for (long k = 0; k < count; ++k)
        for (const Index i : bins_[c * side_ + static_cast<std::size_t>(start + k) % side_]) function(i);
  }

 private:
  std::size_t slot(double share) const {
    return std::min(side_ - 1, static_cast<std::size_t>(share * static_cast<double>(side_)));
  }
  std::size_t column(double u) const { return slot(u / pi); }
  std::size_t row(double v) const { return slot(v / (2 * pi)); }

  std::size_t side_;
  std::vector<std::vector<Index>> bins_;
  std::vector<TorusPoint> points_;
};

/// A target that a path of so many steps reaches is at least half as many away (bounds are within a factor of 2 of
/// short distances), beyond the first two steps.
constexpr double near_steps = 5;

/// The least lengths found so far, and what bounds them.
struct Search {
  const TargetBins& bins;
  double angle, step;
  std::vector<double> bound, best;

  /// Targets so close to the source that cells are too narrow to be inverted; none of the others is in the first two
  /// steps.
  void find_near(double source_v) {
    for (Index t = 0; t < bins.size(); ++t) {
      const TorusPoint& target = bins.point(t);
      const double v = source_v + std::remainder(target.v - source_v, 2 * pi);
      if (bound[t] < near_steps * step) best[t] = direct_length(source_v, target.u, v);
    }
  }

  /// All targets between two neighbouring rays.
  void sweep(const std::vector<RayNode>& left, const std::vector<RayNode>& right) {
    const std::size_t steps = std::min(left.size(), right.size()) - 1;
    for (std::size_t i = 2; i < steps; ++i)  // the narrow ones of the first two steps hold none that is left
      visit_cell(left[i], left[i + 1], right[i], right[i + 1], i);
  }

  void visit_cell(const RayNode& a, const RayNode& b, const RayNode& c, const RayNode& d, std::size_t i) {
    const auto [u_low, u_high] = std::minmax({a.u, b.u, c.u, d.u});
    const auto [v_low, v_high] = std::minmax({a.v, b.v, c.v, d.v});
    // The cell's sides are curves: they leave the box of its corners by far less than a twentieth of their length.
    const double margin = 0.05 * ((u_high - u_low) + (v_high - v_low));
    const double middle = 0.5 * (v_low + v_high), half = 0.5 * (v_high - v_low) + margin,
                 begin = static_cast<double>(i) * step;
    bins.visit(u_low - margin, u_high + margin, middle - half, middle + half, [&, u0 = u_low, u1 = u_high](Index t) {
      const TorusPoint& target = bins.point(t);
      if (begin >= best[t] || begin > bound[t] || target.u < u0 - margin || target.u > u1 + margin) return;
      const double v = target.v + 2 * pi * std::round((middle - target.v) / (2 * pi));
      if (std::abs(v - middle) > half) return;
      const double found = RayCell(a, b, c, d, angle, step).locate(target.u, v);
      if (found >= 0) best[t] = std::min(best[t], begin + found * step);
    });
  }
};

}  // namespace

TorusPoint torus_point(const Vec3& p) {
  return {std::atan2(p.y, p.x), std::atan2(p.z, std::hypot(p.x, p.y) - torus_ring)};
}

Vec3 torus_position(const TorusPoint& p) {
  const double w = torus_ring + torus_tube * std::cos(p.v);
  return {w * std::cos(p.u), w * std::sin(p.u), torus_tube * std::sin(p.v)};
}

std::vector<double> torus_distances(const TorusPoint& source, std::span<const TorusPoint> targets,
                                    const ShootingOptions& options) {
  const TargetBins bins(source, targets);
  const std::size_t half = options.rays / 2;
  Search search{bins, pi / static_cast<double>(half), options.step, {}, std::vector<double>(targets.size(), infinity)};
  double longest = 0;
  for (Index t = 0; t < targets.size(); ++t) {
    search.bound.push_back(upper_bound(source.v, bins.point(t)));
    longest = std::max(longest, search.bound.back());
  }
  search.find_near(source.v);
  // A geodesic that is longer than another path to where it has come is not shortest there, nor beyond. The slack is
  // for targets between it and its neighbours, which may be shortest a little further.
  constexpr double slack = 0.1;
  const auto stop = [&](const RayNode& node, double s) {
    return node.u > pi + slack || s > upper_bound(source.v, {node.u, node.v}) + slack;
  };
  const auto ray = [&](std::size_t k) {
    return shoot(source.v, search.angle * static_cast<double>(k), options.step, longest + 2 * options.step, stop);
  };
  std::vector<RayNode> left = ray(0);
  for (std::size_t k = 1; k <= half; ++k) {
    std::vector<RayNode> right = ray(k);
    search.sweep(left, right);
    left = std::move(right);
  }
  for (std::size_t t = 0; t < targets.size(); ++t)
    if (search.best[t] == infinity && search.bound[t] > 0)
      throw NumericalError("no geodesic was found to target " + std::to_string(t));
    else
      search.best[t] = std::min(search.best[t], search.bound[t]);
  return std::move(search.best);
}

}  // namespace geodrome::bench
