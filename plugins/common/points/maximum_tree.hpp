// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// The upper envelope of cones: max over i of weight(i) - slope |x p(i)|, by branch and bound over a kd-tree whose
/// nodes hold the largest weight below them. The result is bitwise that of the plain loop over all points: rounding is
/// monotone, and a node's bound is computed by the same expression as a point's value, from differences that are
/// nowhere larger; so no bound ever falls below a value in its node. Immutable; thread-safe.
class MaximumTree {
 public:
  /// Builds the tree of as many finite `weights` as `points`, at least one; `slope` >= 0. O(n log n); about 50 bytes a
  /// point.
  MaximumTree(std::span<const Vec3> points, std::span<const double> weights, double slope);

  /// Returns the envelope at `x`. `at_least` is any number that the result is known not to fall below; the closer, the
  /// faster. A search near the previous one may derive it from that: the envelope changes by at most slope times the
  /// distance.
  double evaluate(const Vec3& x, double at_least = -infinity) const;

  /// Returns the indices of the points in the order of the leaves: neighbours in this order are near each other.
  std::span<const Index> leaf_order() const noexcept { return order_; }

 private:
  // Node k has the children 2 k + 1 and 2 k + 2; the points below it are halved between them.
  struct Node {
    Vec3 low, high;
    double weight;
  };

  void build(std::size_t node, std::size_t begin, std::size_t end, std::span<const Vec3> points,
             std::span<const double> weights);
  void search(std::size_t node, std::size_t begin, std::size_t end, const Vec3& x, double& best) const;
  double bound(std::size_t node, const Vec3& x) const;

  double slope_;
  std::vector<Node> nodes_;
  std::vector<Index> order_;
  std::vector<Vec3> points_;  // in leaf order, as are the weights
  std::vector<double> weights_;
};

}  // namespace geodrome
