// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "tools/bench/solvers/witness.hpp"

/// What a solver of distances D, intervals [l, D] and paths promises, against the distances d of an exact one. All is
/// judged up to rounding: 1e-12 of the largest d from the sources. NaN breaks every promise.
namespace geodrome::bench {

/// The first place that breaks a promise, if any does.
using FirstBroken = std::optional<std::size_t>;

/// The worst over all places. Excess is D/d - 1, where d is above rounding.
struct FactorFigures {
  std::size_t places = 0, judged = 0, above = 0;  ///< judged: those that the stated factor covers
  double largest_excess = 0, mean_excess = 0;
  double shortfall = 0;  ///< largest d - D, of the largest d; +inf: D is finite and d is not
  double ratio_sum = 0;  ///< of the excesses, for the mean
  std::size_t ratios = 0;

  void add(const FactorFigures& other);
};

/// Adds the places of one search. `judged`: the first so many are judged by the factor, all are measured. Without a
/// factor (+inf) nothing is promised.
FirstBroken add_places(FactorFigures& figures, std::span<const double> exact, std::span<const double> found,
                       double factor, std::size_t judged);

/// Of the intervals that a solver states by the extension LowerBounds.
struct BoundFigures {
  std::size_t places = 0;
  std::size_t too_long = 0;                     ///< l > d
  std::size_t too_wide = 0;                     ///< D > factor l, where there is a factor
  std::size_t beside = 0;                       ///< |d - D| > D - l, or l finite where there is no path
  double largest_excess = 0, largest_over = 0;  ///< of l/d - 1, and of l - d over the largest d: both from 0 on
  double largest_width = 0, width_sum = 0;      ///< of D/l - 1 at vertices, where l is above rounding
  std::size_t widths = 0;
  std::size_t runs = 0, empty_runs = 0;  ///< empty: l = D at every place, as of an exact search

  void add(const BoundFigures& other);
  std::size_t broken() const { return too_long + too_wide + beside; }
};

/// Adds the intervals of one search at its places, the first `vertices` of them vertices: at other points l may be no
/// more than D over the factor, so that widths tell nothing.
FirstBroken add_bounds(BoundFigures& figures, std::span<const double> exact, std::span<const double> found,
                       std::span<const double> bounds, double factor, std::size_t vertices);

/// Of paths, each with the start distance of its source.
struct PathFigures {
  std::size_t paths = 0;
  std::size_t too_short = 0, too_long = 0;    ///< length below d; with what its ends miss above D, where there is a
                                              ///< factor, or not on the surface
  double largest_excess = 0, excess_sum = 0;  ///< of length/d - 1, where d is above rounding
  double largest_short = 0,
         largest_detour = 0;  ///< of d - length and of length and miss - D, over the largest d, from 0 on
  std::size_t ratios = 0;

  void add(const PathFigures& other);
  std::size_t broken() const { return too_short + too_long; }
};

/// Adds paths of one search, from places with finite D. `scale`: the largest d.
FirstBroken add_paths(PathFigures& figures, std::span<const double> exact, std::span<const double> found,
                      std::span<const MeasuredPath> measured, double factor, double scale);

}  // namespace geodrome::bench
