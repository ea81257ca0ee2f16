// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "plugins/common/parallel_for.hpp"
#include "plugins/common/points/local_plane.hpp"
#include "plugins/tangent_jet/local_jet.hpp"

namespace geodrome {
namespace {

constexpr std::size_t probes = 1000;  // the median is then known to two percent
constexpr std::size_t smallest = 10;  // a quadric has six coefficients
constexpr std::size_t largest = 640;  // smoothing over more costs a millisecond a point

// Measured on six shapes of 600 to 50,000 points, uniform, blue noise and lattices, and on mesh vertices. s(20) /
// s(10): with noise at most 1.42, without 1.5 and more, but for lattices; s(40) / s(20): with noise that 40 neighbours
// can average out below 1.45, on those lattices 2.1 and more.
constexpr double first_growth = 1.45;
constexpr double second_growth = 1.6;
/// Noise is the same everywhere: the lowest tenth of s(20) is above 0.58 of the median with it. Edges are not: 0.45 and
/// less on cubes of 100 and more points, clean, whose growths may pass.
constexpr double even = 0.5;
constexpr std::size_t enough_points = 100;
/// Noise below this share of the spacing turns normals by less than a tenth of a degree and no triangle over; rounding
/// of coordinates is far below it.
constexpr double worthwhile = 0.01;
/// Variance of a fitted quadric at its centre: sigma^2 times this over the number of neighbours.
constexpr double centre_variance = 6;
/// The quadric misses the surface by less at its centre than over its neighbourhood: the share, for smooth shapes.
constexpr double centre_bias = 0.5;
/// Noise left over, as a share of the spacing, that is not worth more neighbours.
constexpr double good_enough = 0.05;

/// The value below which this share of the values are.
double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Standard deviation of the residuals of the unweighted quadric of one point.
double residual_deviation(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  neighbours.nearest_and_ties(points[at], k, around, at);
  const LocalPlane plane = plane_of(points, points[at], around);
  around.insert(around.begin(), {0, at});
  const Quadric quadric = fit_quadric(points, points[at], plane.normal, around, 0);
  double squares = 0;
  for (const Neighbour& n : around) squares += std::pow(quadric.residual(points[n.index] - points[at]), 2);
  return std::sqrt(squares / static_cast<double>(around.size() - quadric.rank));
}

/// The points that are looked at.
std::vector<Index> spread(std::span<const Index> order) {
  const std::size_t count = std::min(probes, order.size());
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(order[i * order.size() / count]);
  return chosen;
}

double median_spacing(const Neighbours& neighbours, std::span<const Index> chosen) {
  std::vector<double> d8;
  std::vector<Neighbour> around;
  for (const Index i : chosen) {
    neighbours.nearest(neighbours.points()[i], near_count, around, i);
    if (!around.empty()) d8.push_back(std::sqrt(around.back().squared_distance));
  }
  return d8.empty() ? 0 : quantile(std::move(d8), 0.5) * std::sqrt(std::numbers::pi / near_count);
}

/// s(k) of every level that was looked at: 10, 20, 40, ... neighbours.
struct Levels {
  std::vector<double> s;
  double evenness = 0;  ///< of s(20): the lowest tenth against the median

  double growth(std::size_t level) const { return s[level - 1] > 0 ? s[level] / s[level - 1] : 1; }
  /// Whether larger neighbourhoods can tell nothing more of sigma.
  bool settled() const {
    for (std::size_t level = 2; level < s.size(); ++level)
      if (growth(level) > growth(level - 1)) return true;
    return false;
  }
  static std::size_t k(std::size_t level) { return smallest << level; }
};

/// The end of the flattest doubling: the first after which the growth increases, for later there may be another flat
/// stretch where the whole shape is within the neighbourhood.
double plateau(const Levels& levels) {
  std::size_t best = 1;
  while (best + 1 < levels.s.size() && levels.growth(best + 1) <= levels.growth(best)) ++best;
  return levels.s[best];
}

/// What is left of the noise at the centre of a quadric.
double variance_left(double sigma, std::size_t level) {
  return centre_variance * sigma * sigma / static_cast<double>(Levels::k(level));
}

/// The neighbourhood of the least expected squared error at its centre, or the smallest that is good enough.
std::size_t best_neighbourhood(const Levels& levels, double sigma, double spacing) {
  std::size_t best = 1;
  double least = infinity;
  for (std::size_t level = 1; level < levels.s.size(); ++level) {
    const double left_out = std::max(0.0, levels.s[level] * levels.s[level] - sigma * sigma);
    const double variance = variance_left(sigma, level);
    const double error = variance + centre_bias * centre_bias * left_out;
    if (error >= least) continue;
    least = error;
    best = level;
    if (variance < good_enough * good_enough * spacing * spacing) break;
  }
  return Levels::k(best);
}

}  // namespace

Noise estimate_noise(const Neighbours& neighbours, std::span<const Index> order, RunContext& context) {
  const std::vector<Index> chosen = spread(order);
  Noise noise;
  noise.neighbourhood = Levels::k(1);
  noise.spacing = median_spacing(neighbours, chosen);
  if (neighbours.size() < enough_points) return noise;
  Levels levels;
  const auto look = [&] {
    const std::size_t k = Levels::k(levels.s.size());
    std::vector<double> deviation(chosen.size());
    parallel_for(chosen.size(), context, {0, 0}, [&](std::size_t begin, std::size_t end) {
      std::vector<Neighbour> around;
      for (std::size_t i = begin; i < end; ++i) deviation[i] = residual_deviation(neighbours, chosen[i], k, around);
    });
    const double middle = quantile(deviation, 0.5);
    levels.s.push_back(middle);
    if (levels.s.size() == 2 && middle > 0) levels.evenness = quantile(std::move(deviation), 0.1) / middle;
  };
  while (levels.s.size() < 3) look();
  noise.significant = levels.growth(1) < first_growth && levels.growth(2) < second_growth && levels.evenness > even &&
                      levels.s[1] > worthwhile * noise.spacing;
  const double enough = good_enough * good_enough * noise.spacing * noise.spacing;
  while (noise.significant && levels.growth(levels.s.size() - 1) < second_growth &&
         Levels::k(levels.s.size()) <= std::min(largest, neighbours.size() - 1)) {
    if (levels.settled() && variance_left(plateau(levels), levels.s.size() - 1) < enough) break;
    look();
  }
  noise.sigma = plateau(levels);
  noise.neighbourhood = best_neighbourhood(levels, noise.sigma, noise.spacing);
  return noise;
}

}  // namespace geodrome
