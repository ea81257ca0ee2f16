// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/lifetime.hpp"

#include <array>

namespace geodrome::schreiber {
namespace {

/// A ray that lies beside the other's ray by less than this share of the distance between two images counts as lying on
/// it: the common ray of a pseudo-source and the generator behind it must not be judged by rounding.
constexpr double same_line = 1e-12;

/// A neighbour of g, with coordinates relative to g.
class Rival {
 public:
  /// Takes the neighbour on the left of g or on its right. Its ray on that side bounds where it can be nearer.
  Rival(const Generator& rival, const Generator& g, bool is_left)
      : wx_(rival.x - g.x),
        wy_(rival.y - g.y),
        later_(rival.sigma - g.sigma),
        size_(std::sqrt(wx_ * wx_ + wy_ * wy_)),
        product_((size_ - later_) * (size_ + later_)),
        ray_x_(is_left ? rival.high_x : -rival.low_x),
        ray_y_(is_left ? rival.high_y : -rival.low_y) {}

  /// Returns the length that a ray of g goes before the rival is nearer on it. `begin` is the least length of the ray
  /// up to the line on which the wavefront is.
  double reach(double ux, double uy, double begin) const {
    const double nearing = 2 * (ux * wx_ + uy * wy_ - later_);
    const double equal = nearing > 0 ? product_ / nearing : infinity;
    // The ray is inside the rival's wedge at r where turn * r + start >= 0.
    const double turn = ray_x_ * uy - ray_y_ * ux - same_line;
    const double start = ray_y_ * wx_ - ray_x_ * wy_ - same_line * size_;
    if (start < 0) return turn > 0 ? std::max(equal, -start / turn) : infinity;
    if (turn >= 0) return equal;
    const double end = -start / turn;
    return end > begin && equal < end ? equal : infinity;
  }

  /// Computes the directions in which this rival and another are as far as g: u (c_a w_b - c_b w_a) = c_a s_b - c_b
  /// s_a. Returns their number, 0 or 2.
  static int crossings(const Rival& a, const Rival& b, std::array<double, 4>& u) {
    const double vx = a.product_ * b.wx_ - b.product_ * a.wx_, vy = a.product_ * b.wy_ - b.product_ * a.wy_;
    const double k = a.product_ * b.later_ - b.product_ * a.later_, square = vx * vx + vy * vy;
    if (!(square > 0)) return 0;
    const double across = std::sqrt(std::max(0.0, square - k * k));
    u = {(k * vx - across * vy) / square, (k * vy + across * vx) / square, (k * vx + across * vy) / square,
         (k * vy - across * vx) / square};
    return 2;
  }

 private:
  double wx_, wy_, later_, size_, product_, ray_x_, ray_y_;
};

bool in_wedge(const Generator& g, double ux, double uy) {
  return g.low_x * uy - g.low_y * ux <= 0 && g.high_x * uy - g.high_y * ux >= 0;
}

}  // namespace

double lifetime(const Generator* left, const Generator& g, const Generator* right) {
  if (g.is_sliver()) return 0;
  const double begin = -g.y;
  if (!left && !right) return infinity;
  if (!left) return g.sigma + Rival(*right, g, false).reach(g.low_x, g.low_y, begin);
  if (!right) return g.sigma + Rival(*left, g, true).reach(g.high_x, g.high_y, begin);
  const Rival a(*left, g, true), b(*right, g, false);
  double best = 0;
  const auto try_ray = [&](double ux, double uy) {
    best = std::max(best, std::min(a.reach(ux, uy, begin), b.reach(ux, uy, begin)));
  };
  try_ray(g.low_x, g.low_y);
  try_ray(g.high_x, g.high_y);
  std::array<double, 4> u;
  const int count = best < infinity ? Rival::crossings(a, b, u) : 0;
  for (int i = 0; i < count; ++i) {
    const double size = std::sqrt(u[2 * i] * u[2 * i] + u[2 * i + 1] * u[2 * i + 1]);
    if (!(size > 0)) continue;
    const double ux = u[2 * i] / size, uy = u[2 * i + 1] / size;
    if (in_wedge(g, ux, uy)) try_ray(ux, uy);
  }
  return g.sigma + best;
}

}  // namespace geodrome::schreiber
