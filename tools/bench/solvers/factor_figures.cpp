// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/factor_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/bench/solvers/exactness.hpp"

namespace geodrome::bench {
namespace {

void note(FirstBroken& first, std::size_t place) {
  if (!first) first = place;
}

}  // namespace

void FactorFigures::add(const FactorFigures& other) {
  largest_excess = ratios == 0         ? other.largest_excess
                   : other.ratios == 0 ? largest_excess
                                       : std::max(largest_excess, other.largest_excess);
  places += other.places, judged += other.judged, above += other.above;
  shortfall = std::max(shortfall, other.shortfall);
  ratio_sum += other.ratio_sum, ratios += other.ratios;
  mean_excess = ratios ? ratio_sum / static_cast<double>(ratios) : 0;
}

FirstBroken add_places(FactorFigures& figures, std::span<const double> exact, std::span<const double> found,
                       double factor, std::size_t judged) {
  const double scale = largest_finite(exact), rounding = value_limit * scale;
  FactorFigures added{.places = found.size(), .judged = std::min(judged, found.size())};
  FirstBroken first;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double is = exact[i], claimed = found[i];
    if (is == claimed && std::isinf(is)) continue;
    if (is > rounding && std::isfinite(is))
      added.add({.largest_excess = claimed / is - 1, .ratio_sum = claimed / is - 1, .ratios = 1});
    const bool above = i < judged && !(claimed <= factor * is + rounding), measurable = std::isfinite(is + claimed);
    const double shortfall = claimed >= is ? 0 : measurable ? (is - claimed) / scale : infinity;
    raise(added.shortfall, shortfall);
    if (!std::isfinite(factor)) continue;
    added.above += above;
    if (above || shortfall > value_limit) note(first, i);
  }
  figures.add(added);
  return first;
}

void BoundFigures::add(const BoundFigures& other) {
  places += other.places;
  too_long += other.too_long, too_wide += other.too_wide, beside += other.beside;
  raise(largest_excess, other.largest_excess), raise(largest_over, other.largest_over);
  raise(largest_width, other.largest_width);
  width_sum += other.width_sum, widths += other.widths;
  runs += other.runs, empty_runs += other.empty_runs;
}

FirstBroken add_bounds(BoundFigures& figures, std::span<const double> exact, std::span<const double> found,
                       std::span<const double> bounds, double factor, std::size_t vertices) {
  const double scale = largest_finite(exact), rounding = value_limit * scale;
  BoundFigures added{.places = found.size(), .runs = 1};
  FirstBroken first;
  bool empty = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double d = exact[i], upper = found[i], l = bounds[i];
    empty = empty && l == upper;
    if (std::isinf(d) && l == infinity && upper == infinity) continue;
    const bool too_long = !(l <= d + rounding), too_wide = std::isfinite(factor) && !(upper <= factor * l + rounding);
    const bool beside = !(std::abs(d - upper) <= upper - l + rounding);
    added.too_long += too_long, added.too_wide += too_wide, added.beside += beside;
    if (too_long || too_wide || beside) note(first, i);
    raise(added.largest_over, (l - d) / scale);
    if (d > rounding) raise(added.largest_excess, l / d - 1);
    if (i >= vertices || !(l > rounding)) continue;
    raise(added.largest_width, upper / l - 1);
    added.width_sum += upper / l - 1, ++added.widths;
  }
  added.empty_runs = empty;
  figures.add(added);
  return first;
}

void PathFigures::add(const PathFigures& other) {
  paths += other.paths, too_short += other.too_short, too_long += other.too_long;
  raise(largest_excess, other.largest_excess), raise(largest_short, other.largest_short);
  raise(largest_detour, other.largest_detour);
  excess_sum += other.excess_sum, ratios += other.ratios;
}

FirstBroken add_paths(PathFigures& figures, std::span<const double> exact, std::span<const double> found,
                      std::span<const MeasuredPath> measured, double factor, double scale) {
  const double rounding = value_limit * scale;
  PathFigures added{.paths = measured.size()};
  FirstBroken first;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double d = exact[i], upper = found[i], length = measured[i].length, joined = length + measured[i].miss;
    const bool too_short = !(length >= d - rounding);
    const bool too_long = !(joined <= (std::isfinite(factor) ? upper + rounding : std::numeric_limits<double>::max()));
    added.too_short += too_short, added.too_long += too_long;
    if (too_short || too_long) note(first, i);
    raise(added.largest_short, (d - length) / scale), raise(added.largest_detour, (joined - upper) / scale);
    if (!(d > rounding)) continue;
    raise(added.largest_excess, joined / d - 1);
    added.excess_sum += joined / d - 1, ++added.ratios;
  }
  figures.add(added);
  return first;
}

}  // namespace geodrome::bench
