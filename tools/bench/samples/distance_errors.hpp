// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

namespace geodrome::bench {

/// What far and near mean: shares of the largest true distance.
inline constexpr double far_share = 0.25, near_share = 0.05;

/// How many times an estimate errors are held against.
inline constexpr std::array<double, 3> estimate_factors{1, 2, 4};

/// Relative errors of distances, by how far apart the points truly are. A mean over no pair is 0.
struct DistanceErrors {
  struct Group {
    std::size_t pairs = 0, over_pairs = 0, under_pairs = 0;
    double mean = 0;                       ///< of |error|, over all pairs
    double mean_over = 0, mean_under = 0;  ///< over the pairs that are too long, and those too short, both positive
    double largest_over = 0, largest_under = 0;
    std::array<std::size_t, 3> within{};  ///< pairs whose |error| is at most so many estimates, by `estimate_factors`

    double share_within(std::size_t factor) const {  ///< of the pairs; the factor by its place
      return static_cast<double>(within[factor]) / static_cast<double>(pairs);
    }
    double largest() const { return largest_over > largest_under ? largest_over : largest_under; }
  };
  Group far;   ///< at least a quarter of the largest true distance apart
  Group all;   ///< above 0 apart
  Group near;  ///< less than a twentieth of it, and above 0
};

/// Compares rows of computed distances with the true ones. Precondition: the same shape; computed ones are finite or
/// count as errors of their own size (+inf). `estimate`: of the relative error, which the pairs are held against.
DistanceErrors distance_errors(std::span<const std::vector<double>> truth,
                               std::span<const std::vector<double>> computed, double estimate = 0);

}  // namespace geodrome::bench
