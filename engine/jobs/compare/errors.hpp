// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace geodrome {

/// Distances, one row per source, one column per target: +inf not reached, NaN not computed.
using DistanceRows = std::vector<std::vector<double>>;

/// Pairs are near below this share of the largest true distance, and far from the other one on.
inline constexpr double near_share = 0.05, far_share = 0.25;

/// The mean and the maximum of |D / T - 1| over some pairs; meaningless if none were compared.
struct ErrorSummary {
  std::uint64_t compared = 0;
  double mean = 0, max = 0;
};

/// A histogram of |D / T - 1|. A bin holds values from one edge to below the next; the last one also those beyond.
struct ErrorHistogram {
  std::vector<double> decades;        ///< log10 of the edges: half decades from -17, below all rounding, to 1
  std::vector<std::uint64_t> counts;  ///< one less
  std::uint64_t zero = 0;
};

/// Relative errors D / T - 1 over the pairs that both reach, with T > 0.
struct ErrorFigures {
  static constexpr double shares[] = {0.5, 0.9, 0.99, 1};

  ErrorSummary all, near, far;
  double max_over = 0, max_under = 0;  ///< both >= 0
  std::vector<double> quantiles;       ///< of |D / T - 1| for `shares`, by nearest rank; empty if none were compared
  ErrorHistogram histogram;
  std::uint64_t reach_differs = 0;  ///< pairs that only one of both reaches
  std::uint64_t unreachable = 0;    ///< pairs without a path by D
};

/// Precondition: rows of the same shape. O(n log n).
ErrorFigures compare_distances(const DistanceRows& distances, const DistanceRows& truth);

}  // namespace geodrome
