// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/torus_rays.hpp"

#include <array>
#include <cmath>

#include "tools/bench/shapes/torus_truth.hpp"

namespace geodrome::bench {
namespace {

/// u, v, v' and their derivatives by theta.
using State = std::array<double, 6>;

/// Clairaut's constant c = w^2 u' of a ray, and its derivative by theta.
struct Clairaut {
  double c, c_t;
};

/// With c, the geodesic equations become u' = c / w^2, v'' = -c^2 sin v / (r w^3).
State derivative(const State& y, const Clairaut& ray) {
  const double sine = std::sin(y[1]), cosine = std::cos(y[1]);
  const double w = torus_ring + torus_tube * cosine, w_v = -torus_tube * sine;
  const double square = 1 / (w * w), cube = square / w, bend = 1 / torus_tube * cube;
  const double by_v = ray.c * ray.c * bend * (cosine - 3 * sine * w_v / w);
  return {ray.c * square,
          y[2],
          -ray.c * ray.c * sine * bend,
          ray.c_t * square - 2 * ray.c * w_v * cube * y[4],
          y[5],
          -2 * ray.c * ray.c_t * sine * bend - by_v * y[4]};
}

State along(const State& y, double step, const State& slope) {
  State result;
  for (std::size_t i = 0; i < y.size(); ++i) result[i] = y[i] + step * slope[i];
  return result;
}

State runge_kutta(const State& y, const State& k1, double step, const Clairaut& ray) {
  const State k2 = derivative(along(y, step / 2, k1), ray);
  const State k3 = derivative(along(y, step / 2, k2), ray);
  const State k4 = derivative(along(y, step, k3), ray);
  State result;
  for (std::size_t i = 0; i < y.size(); ++i) result[i] = y[i] + step / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
  return result;
}

/// Cubic Hermite basis on [0, 1]: at end 0 and 1, of value and slope, and their derivatives.
struct Basis {
  double value[2], slope[2], value_d[2], slope_d[2];

  explicit Basis(double x) {
    const double y = 1 - x;
    value[0] = y * y * (1 + 2 * x), value[1] = x * x * (1 + 2 * y);
    slope[0] = x * y * y, slope[1] = -x * x * y;
    value_d[0] = -6 * x * y, value_d[1] = 6 * x * y;
    slope_d[0] = y * (1 - 3 * x), slope_d[1] = x * (3 * x - 2);
  }
};

}  // namespace

std::vector<RayNode> shoot(double v, double theta, double step, double length,
                           const std::function<bool(const RayNode&, double)>& stop) {
  const double w = torus_ring + torus_tube * std::cos(v), sine = std::sin(theta), cosine = std::cos(theta);
  const Clairaut ray{w * sine, w * cosine};
  State y{0, v, cosine / torus_tube, 0, 0, -sine / torus_tube};
  std::vector<RayNode> nodes;
  for (std::size_t i = 0;; ++i) {
    const State d = derivative(y, ray);
    nodes.push_back({y[0], y[1], d[0], d[1], y[3], y[4], d[3], d[4]});
    const double s = static_cast<double>(i) * step;
    if (i > 0 && (s >= length || (stop && stop(nodes.back(), s)))) return nodes;
    y = runge_kutta(y, d, step, ray);
  }
}

double direct_length(double v, double u_target, double v_target) {
  constexpr int most_rounds = 30, steps = 8;  // a round gains more than a digit
  constexpr double rounding = 1e-15;
  const double w = torus_ring + torus_tube * std::cos(v);
  double x = w * u_target, y = torus_tube * (v_target - v);
  for (int round = 0; round < most_rounds; ++round) {
    const double length = std::hypot(x, y);
    if (length == 0) return 0;
    const RayNode end = shoot(v, std::atan2(x, y), length / steps, length).back();
    const double dx = w * (u_target - end.u), dy = torus_tube * (v_target - end.v);
    x += dx, y += dy;
    if (std::hypot(dx, dy) < rounding) break;
  }
  return std::hypot(x, y);
}

RayCell::RayCell(const RayNode& near0, const RayNode& far0, const RayNode& near1, const RayNode& far1, double angle,
                 double step) {
  const RayNode* corners[4] = {&near0, &far0, &near1, &far1};
  int turned = 0;
  for (int i = 0; i < 4; ++i) {
    const RayNode& n = *corners[i];
    const double u[4] = {n.u, angle * n.u_t, step * n.u_s, angle * step * n.u_st};
    const double v[4] = {n.v, angle * n.v_t, step * n.v_s, angle * step * n.v_st};
    for (int k = 0; k < 4; ++k) u_[i][k] = u[k], v_[i][k] = v[k];
    turned += n.u_t * n.v_s - n.v_t * n.u_s > 0;
  }
  folded_ = turned > 0 && turned < 4;
}

RayCell::Value RayCell::at(double a, double b) const {
  const Basis p(a), q(b);
  Value sum{};
  for (int corner = 0; corner < 4; ++corner) {
    const int i = corner / 2, j = corner % 2;
    const double weight[4] = {p.value[i] * q.value[j], p.slope[i] * q.value[j], p.value[i] * q.slope[j],
                              p.slope[i] * q.slope[j]};
    const double by_a[4] = {p.value_d[i] * q.value[j], p.slope_d[i] * q.value[j], p.value_d[i] * q.slope[j],
                            p.slope_d[i] * q.slope[j]};
    const double by_b[4] = {p.value[i] * q.value_d[j], p.slope[i] * q.value_d[j], p.value[i] * q.slope_d[j],
                            p.slope[i] * q.slope_d[j]};
    for (int k = 0; k < 4; ++k) {
      sum.u += weight[k] * u_[corner][k], sum.v += weight[k] * v_[corner][k];
      sum.u_a += by_a[k] * u_[corner][k], sum.v_a += by_a[k] * v_[corner][k];
      sum.u_b += by_b[k] * u_[corner][k], sum.v_b += by_b[k] * v_[corner][k];
    }
  }
  return sum;
}

double RayCell::newton(double u, double v, double a, double b) const {
  constexpr int most_steps = 12;
  constexpr double reached = 1e-11;  // radians: far below the error of 1e-7 that is promised, far above rounding
  constexpr double inside = 1e-6;    // neighbouring cells overlap by so much, so that no target falls between
  // Newton's steps may leave the cell by so much and come back: close to the source the sides of a cell are ten times
  // as far from straight as the cell is wide.
  constexpr double lost_a = 50, lost_b = 1.5;
  for (int step = 0; step < most_steps; ++step) {
    const Value here = at(a, b);
    const double du = u - here.u, dv = v - here.v;
    if (std::abs(du) + std::abs(dv) < reached) {
      const bool within = a >= -inside && a <= 1 + inside && b >= -inside && b <= 1 + inside;
      return within ? std::max(b, 0.0) : -1;
    }
    const double determinant = here.u_a * here.v_b - here.v_a * here.u_b;
    a += (du * here.v_b - dv * here.u_b) / determinant;
    b += (here.u_a * dv - here.v_a * du) / determinant;
    if (!(std::abs(a - 0.5) < lost_a && std::abs(b - 0.5) < lost_b)) return -1;
  }
  return -1;
}

double RayCell::locate(double u, double v) const {
  double best = newton(u, v, 0.5, 0.5);
  if (!folded_) return best;
  for (const double a : {0.05, 0.3, 0.7, 0.95})
    for (const double b : {0.1, 0.9}) {
      const double found = newton(u, v, a, b);
      if (found >= 0 && (best < 0 || found < best)) best = found;
    }
  return best;
}

}  // namespace geodrome::bench
