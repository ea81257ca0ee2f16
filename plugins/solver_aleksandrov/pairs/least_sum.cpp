// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/pairs/least_sum.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "plugins/solver_aleksandrov/processor_levels.hpp"

namespace geodrome::aleksandrov {

GEODROME_PROCESSOR_LEVELS float least_sum(const float* a, const float* b, std::size_t count) {
  using Eight = float __attribute__((vector_size(32)));
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Eight least[2];
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 8; ++i) least[k][i] = infinity;
  std::size_t i = 0;
  for (; i + 16 <= count; i += 16)
    for (int k = 0; k < 2; ++k) {
      Eight x, y;
      std::memcpy(&x, a + i + 8 * k, sizeof x);
      std::memcpy(&y, b + i + 8 * k, sizeof y);
      const Eight sum = x + y;
      least[k] = sum < least[k] ? sum : least[k];
    }
  float result = infinity;
  for (; i < count; ++i) result = std::min(result, a[i] + b[i]);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 8; ++j) result = std::min(result, least[k][j]);
  return result;
}

}  // namespace geodrome::aleksandrov
