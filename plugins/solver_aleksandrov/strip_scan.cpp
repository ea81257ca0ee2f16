// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/strip_scan.hpp"

#include <cstdint>
#include <cstring>

#include "plugins/solver_aleksandrov/processor_levels.hpp"

namespace geodrome::aleksandrov {
namespace {

using Four = double __attribute__((vector_size(32)));
using FourBits = std::int64_t __attribute__((vector_size(32)));

}  // namespace

/// Comparisons by squares, four at once; few ways are not longer, so a branch for eight is foreseen as a rule.
GEODROME_PROCESSOR_LEVELS void scan_strip(const double* t, const double* best, std::size_t count, double base, double x,
                                          double y, double dx, double dy, Index first, std::vector<Index>& out) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    FourBits within[2];
    for (int k = 0; k < 2; ++k) {
      Four at, length;
      std::memcpy(&at, t + i + 4 * k, sizeof at);
      std::memcpy(&length, best + i + 4 * k, sizeof length);
      const Four slack = length - base, px = x - at * dx, py = y - at * dy;
      within[k] = (slack >= 0) & (px * px + py * py <= slack * slack);
    }
    const FourBits any = within[0] | within[1];
    if ((any[0] | any[1] | any[2] | any[3]) == 0) continue;
    for (int k = 0; k < 8; ++k)
      if (within[k / 4][k % 4]) out.push_back(first + static_cast<Index>(i) + k);
  }
  for (; i < count; ++i) {
    const double slack = best[i] - base, px = x - t[i] * dx, py = y - t[i] * dy;
    if (slack >= 0 && px * px + py * py <= slack * slack) out.push_back(first + static_cast<Index>(i));
  }
}

}  // namespace geodrome::aleksandrov
