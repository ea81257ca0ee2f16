// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "plugins/common/points/neighbours.hpp"
#include "plugins/tangent_jet/smooth/quartic.hpp"

namespace geodrome {

/// A quartic fitted by weighted least squares, with what it tells of its own error.
struct QuarticFit {
  using Matrix = Eigen::Matrix<double, quartic_size, quartic_size>;

  Quartic quartic;
  Matrix factor;                ///< lower triangle L; the normal equations are L L^T, with lengths in units of `radius`
  double radius = 1;            ///< distance of the farthest point that was used
  double residual = 0;          ///< standard deviation of the points across the quartic, by the degrees of freedom left
  int degree = quartic_degree;  ///< of the highest coefficient that was fitted
  bool pinned = false;          ///< without a constant: the surface passes through the base
  bool determined = false;      ///< whether the points determine all coefficients, with some to spare; else all are 0

  /// How many times the standard deviation of the points that of the height over a point of the plane is, at most.
  double leverage(double x, double y) const;
};

/// How a quartic is fitted.
struct FitRule {
  double decay;                 ///< weights are exp(-decay d^2 / r^2), r being the distance of the last point
  bool pinned;                  ///< through the base
  int degree = quartic_degree;  ///< coefficients of higher degree are 0
};

/// Fits a quartic over the plane through `base` with `normal`, which is of unit length, to the points `around`, which
/// ascend in distance. O(points).
QuarticFit fit_quartic(const std::vector<Vec3>& points, const std::vector<Neighbour>& around, const Vec3& base,
                       const Vec3& normal, const FitRule& rule);

}  // namespace geodrome
