// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace geodrome::shapes {

/// Seeded random numbers whose bytes do not depend on the standard library: the engine std::mt19937_64 is fixed by the
/// standard, the distributions of <random> are not, so the mapping to numbers is done here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// From 0 to count - 1; count > 0. The bias, below count / 2^53, is far below what any sample here can show.
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(uniform() * static_cast<double>(count)); }

  /// Normal with mean 0 and standard deviation 1 (Box and Muller 1958; the second number of each pair is not used).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace geodrome::shapes
