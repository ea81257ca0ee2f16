// SPDX-License-Identifier: MIT
#include "tools/bench/samples/distance_errors.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::bench {
namespace {

void add(DistanceErrors::Group& group, double error, double estimate) {
  ++group.pairs, group.mean += std::abs(error);
  for (std::size_t k = 0; k < estimate_factors.size(); ++k)
    group.within[k] += std::abs(error) <= estimate_factors[k] * estimate;
  if (error > 0) ++group.over_pairs, group.mean_over += error, group.largest_over = std::max(group.largest_over, error);
  if (error < 0)
    ++group.under_pairs, group.mean_under -= error, group.largest_under = std::max(group.largest_under, -error);
}

/// Sums become means.
void finish(DistanceErrors::Group& group) {
  const auto divide = [](double& sum, std::size_t count) {
    if (count > 0) sum /= static_cast<double>(count);
  };
  divide(group.mean, group.pairs), divide(group.mean_over, group.over_pairs);
  divide(group.mean_under, group.under_pairs);
}

}  // namespace

DistanceErrors distance_errors(std::span<const std::vector<double>> truth,
                               std::span<const std::vector<double>> computed, double estimate) {
  double largest = 0;
  for (const std::vector<double>& row : truth) largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  DistanceErrors errors;
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < truth[i].size(); ++j) {
      const double is = truth[i][j];
      if (is == 0) continue;
      const double error = (computed[i][j] - is) / is;
      add(errors.all, error, estimate);
      if (is >= far_share * largest) add(errors.far, error, estimate);
      if (is < near_share * largest) add(errors.near, error, estimate);
    }
  finish(errors.all), finish(errors.far), finish(errors.near);
  return errors;
}

}  // namespace geodrome::bench
