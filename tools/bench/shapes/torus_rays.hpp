// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

/// Geodesics on the torus of torus_truth.hpp, and the map between two of them.
namespace geodrome::bench {

/// The exponential map at a starting angle theta and a length s: where the geodesic is, and the derivatives.
struct RayNode {
  double u, v;      ///< not reduced to one turn
  double u_s, v_s;  ///< by arc length
  double u_t, v_t;  ///< by theta: the Jacobi field
  double u_st, v_st;
};

/// The geodesic that leaves (0, v) at angle theta from the direction of growing v, towards growing u (0 <= theta <=
/// pi), at lengths 0, step, 2 step, ... up to `length`, or until `stop(node, s)`; at least two nodes.
std::vector<RayNode> shoot(double v, double theta, double step, double length,
                           const std::function<bool(const RayNode&, double)>& stop = {});

/// The length of the geodesic from (0, v) to a target at most 0.1 away: Newton's method in normal coordinates, with the
/// derivative at the start, where the map of polar coordinates is singular.
double direct_length(double v, double u_target, double v_target);

/// The exponential map between two rays and two steps: bicubic Hermite in a (theta) and b (s), both from 0 to 1.
class RayCell {
 public:
  RayCell(const RayNode& near0, const RayNode& far0, const RayNode& near1, const RayNode& far1, double angle,
          double step);

  /// Where (u, v) lies in the cell: the b of it, if it is inside (up to rounding) and was found; else a negative
  /// number. Of several places the least b that is found.
  double locate(double u, double v) const;

 private:
  struct Value {
    double u, v, u_a, v_a, u_b, v_b;
  };
  Value at(double a, double b) const;
  double newton(double u, double v, double a, double b) const;

  double u_[4][4], v_[4][4];  ///< per corner: value, by a, by b, by both
  bool folded_;               ///< the map turns over inside: near conjugate points
};

}  // namespace geodrome::bench
