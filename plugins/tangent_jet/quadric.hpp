// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "geodrome/geometry.hpp"

namespace geodrome {

/// A height function of degree two over the plane through `base` with unit vectors u, v and normal n: a 2-jet.
struct Quadric {
  Vec3 u, v, n;
  double scale = 1;                 ///< lengths are in this unit inside
  Eigen::Matrix<double, 6, 1> jet;  ///< of 1, x, y, x^2, sqrt(2) xy, y^2
  unsigned rank = 0;                ///< how many coefficients the points determine

  /// Height over the base of the surface above it, in the units of the input.
  double height() const { return scale * jet[0]; }
  /// Unit normal of the surface above the base.
  Vec3 normal() const;
  /// How far the point at `offset` from the base is above the surface, along n.
  double residual(const Vec3& offset) const;
};

/// Weighted least squares for a Quadric: add points, then solve.
///
/// The basis is orthogonal under rotation in the plane (hence sqrt(2) xy), and coefficients that the points do not
/// determine (fewer than six, rows of a scan, points on a conic) are the smallest possible: so the result depends on
/// the points and the normal alone, not on the axes.
class QuadricSystem {
 public:
  /// `scale`: about the distance of the farthest point, so that all coefficients weigh alike.
  QuadricSystem(const Vec3& normal, double scale);
  void add(const Vec3& offset, double weight = 1);
  Quadric solve() const;

 private:
  Quadric frame_;
  Eigen::Matrix<double, 6, 6> matrix_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right_ = Eigen::Matrix<double, 6, 1>::Zero();
};

}  // namespace geodrome
