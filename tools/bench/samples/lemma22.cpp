// SPDX-License-Identifier: MIT
#include "tools/bench/samples/lemma22.hpp"

#include <algorithm>
#include <cmath>

namespace geodrome::bench {

std::size_t coarser(std::size_t points) {
  return static_cast<std::size_t>(std::lround(std::pow(static_cast<double>(points), case1_points)));
}

double epsilon_constant(std::span<const std::size_t> points, std::span<const double> epsilon) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    sum += std::log(epsilon[i] * std::sqrt(static_cast<double>(points[i])));
  return std::exp(sum / static_cast<double>(points.size()));
}

double delta_of(double constant, std::size_t points) {
  return std::min(1.0, constant / std::sqrt(static_cast<double>(points)));
}

}  // namespace geodrome::bench
