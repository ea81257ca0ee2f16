// SPDX-License-Identifier: MIT
#include "engine/report/comparison.hpp"

#include <algorithm>

namespace geodrome {

double SearchCost::median_seconds() const {
  if (source_seconds.empty()) return 0;
  std::vector<double> sorted = source_seconds;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  return sorted.size() % 2 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

std::vector<std::string> broken_promises(const ComparisonFigures& figures) {
  std::vector<std::string> broken;
  for (const CombinationFigures& combination : figures.combinations) {
    if (!combination.ran()) continue;
    for (const auto& [name, check] : combination.invariants)
      if (!check.holds())
        broken.push_back(combination.name + ": " + name + " fails " + std::to_string(check.violated) + " times of " +
                         std::to_string(check.tested));
    if (combination.guarantee.held == false) broken.push_back(combination.name + ": " + combination.guarantee.why);
  }
  return broken;
}

}  // namespace geodrome
