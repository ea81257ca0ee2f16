// SPDX-License-Identifier: MIT
#include "tools/shapes/implicit_sampler.hpp"

#include <cmath>

#include "geodrome/errors.hpp"

namespace geodrome::shapes {
namespace {

/// A line parallel to an axis; the parameter is the coordinate along it.
struct AxisLine {
  const Implicit& surface;
  Vec3 base;
  int axis;

  Vec3 point(double t) const {
    Vec3 p = base;
    (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = t;
    return p;
  }
  double value(double t) const { return surface.at(point(t)).value; }
  double slope(const LevelValue& f) const { return axis == 0 ? f.gradient.x : axis == 1 ? f.gradient.y : f.gradient.z; }
};

/// The root in [low, high] of a function with one sign change there: Newton's steps, bisection where they leave.
double bracketed_root(const AxisLine& line, double low, double high) {
  const bool rising = line.value(low) < 0;
  double t = 0.5 * (low + high);
  for (int step = 0; step < 200; ++step) {
    const LevelValue f = line.surface.at(line.point(t));
    ((f.value < 0) == rising ? low : high) = t;
    double next = t - f.value / line.slope(f);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 1e-16 * (1 + std::abs(t)) || next == low || next == high) return next;
    t = next;
  }
  return t;
}

/// Appends every root in [low, high], ascending. Pieces are ruled out, or found monotone, by the bound on the second
/// derivative; what is still undecided at 1e-10 is a touching line, which has probability 0.
void roots(const AxisLine& line, double low, double high, std::vector<double>& out) {
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const LevelValue f = line.surface.at(line.point(middle));
  const double slope = std::abs(line.slope(f)), bend = half * line.surface.second_derivative;
  if (std::abs(f.value) > half * (slope + 0.5 * bend) || half < 1e-10) return;
  if (slope > bend) {
    if ((line.value(low) < 0) != (line.value(high) < 0)) out.push_back(bracketed_root(line, low, high));
    return;
  }
  roots(line, low, middle, out);
  roots(line, middle, high, out);
}

/// Small against the curvature of the surfaces, which have size 1, so that lines meet a cell's piece at most twice.
constexpr double sampler_spacing = 0.03;

}  // namespace

ImplicitSampler::ImplicitSampler(const Implicit& surface)
    : surface_(surface), grid_(surface, sampler_spacing), cells_(cells_near(surface, grid_)) {}

Vec3 ImplicitSampler::draw(Random& random) const {
  constexpr std::size_t most_meetings = 2;
  std::vector<double> meetings;
  for (;;) {
    const Vec3 low = grid_.corner(cells_[random.index(cells_.size())]);
    const int axis = static_cast<int>(random.index(3));
    const double a = grid_.spacing * random.uniform(), b = grid_.spacing * random.uniform();
    const AxisLine line{surface_, low + (axis == 0 ? Vec3{0, a, b} : axis == 1 ? Vec3{a, 0, b} : Vec3{a, b, 0}), axis};
    const double start = axis == 0 ? low.x : axis == 1 ? low.y : low.z;
    meetings.clear();
    roots(line, start, start + grid_.spacing, meetings);
    if (meetings.size() > most_meetings)
      throw NumericalError(std::string(surface_.kind) + ": the sampler's cells are too large");
    const std::size_t chosen = random.index(most_meetings);
    if (chosen >= meetings.size()) continue;
    const Vec3 point = line.point(meetings[chosen]), gradient = surface_.at(point).gradient;
    const double density = (std::abs(gradient.x) + std::abs(gradient.y) + std::abs(gradient.z)) / norm(gradient);
    if (random.uniform() * density < 1) return point;
  }
}

}  // namespace geodrome::shapes
