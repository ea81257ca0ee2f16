// SPDX-License-Identifier: MIT
#include "plugins/common/points/maximum_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace geodrome {
namespace {

constexpr std::size_t leaf_size = 8;

/// Evaluates the one expression for values and bounds: it must not be written twice.
double cone(double weight, double slope, const Vec3& difference) { return weight - slope * norm(difference); }

/// Returns the distance from `x` to the interval, without sign; 0 inside.
double outside(double x, double low, double high) { return std::max({low - x, x - high, 0.0}); }

double coordinate(const Vec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

int longest_axis(const Vec3& extent) {
  if (extent.x >= extent.y && extent.x >= extent.z) return 0;
  return extent.y >= extent.z ? 1 : 2;
}

std::size_t node_count(std::size_t points) {
  std::size_t leaves = 1;
  while (points > leaf_size * leaves) leaves *= 2;
  return 2 * leaves - 1;
}

}  // namespace

MaximumTree::MaximumTree(std::span<const Vec3> points, std::span<const double> weights, double slope)
    : slope_(slope), nodes_(node_count(points.size())), order_(points.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  build(0, 0, points.size(), points, weights);
  points_.reserve(points.size());
  weights_.reserve(points.size());
  for (const Index i : order_) {
    points_.push_back(points[i]);
    weights_.push_back(weights[i]);
  }
}

void MaximumTree::build(std::size_t node, std::size_t begin, std::size_t end, std::span<const Vec3> points,
                        std::span<const double> weights) {
  Vec3 low = points[order_[begin]], high = low;
  double weight = weights[order_[begin]];
  for (std::size_t i = begin + 1; i < end; ++i) {
    const Vec3& p = points[order_[i]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    weight = std::max(weight, weights[order_[i]]);
  }
  nodes_[node] = {low, high, weight};
  if (2 * node + 2 >= nodes_.size()) return;
  const int axis = longest_axis(high - low);
  const std::size_t middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](Index a, Index b) {
    const double u = coordinate(points[a], axis), v = coordinate(points[b], axis);
    return u != v ? u < v : a < b;
  });
  build(2 * node + 1, begin, middle, points, weights);
  build(2 * node + 2, middle, end, points, weights);
}

double MaximumTree::evaluate(const Vec3& x, double at_least) const {
  double best = at_least;
  search(0, 0, points_.size(), x, best);
  return best;
}

void MaximumTree::search(std::size_t node, std::size_t begin, std::size_t end, const Vec3& x, double& best) const {
  if (2 * node + 2 >= nodes_.size()) {
    for (std::size_t i = begin; i < end; ++i) best = std::max(best, cone(weights_[i], slope_, x - points_[i]));
    return;
  }
  const std::size_t middle = (begin + end) / 2;
  const double left = bound(2 * node + 1, x), right = bound(2 * node + 2, x);
  const bool left_first = left >= right;
  for (const bool go_left : {left_first, !left_first}) {
    if ((go_left ? left : right) <= best) continue;
    if (go_left)
      search(2 * node + 1, begin, middle, x, best);
    else
      search(2 * node + 2, middle, end, x, best);
  }
}

double MaximumTree::bound(std::size_t node, const Vec3& x) const {
  const Node& n = nodes_[node];
  return cone(n.weight, slope_,
              {outside(x.x, n.low.x, n.high.x), outside(x.y, n.low.y, n.high.y), outside(x.z, n.low.z, n.high.z)});
}

}  // namespace geodrome
