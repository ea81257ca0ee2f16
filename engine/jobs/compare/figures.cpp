// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/figures.hpp"

#include "engine/formats/number_text.hpp"
#include "engine/report/median.hpp"

namespace geodrome {

double SearchCost::median_seconds() const { return source_seconds.empty() ? 0 : median(source_seconds); }

std::vector<std::string> broken_promises(const ComparisonFigures& figures) {
  std::vector<std::string> broken;
  for (const CombinationFigures& combination : figures.combinations) {
    if (!combination.ran()) continue;
    for (const auto& [name, check] : combination.invariants)
      if (!check.holds())
        broken.push_back(combination.name + ": " + name + " fails " + std::to_string(check.violated) + " times of " +
                         std::to_string(check.tested));
    if (combination.certified && !combination.certified->hold())
      broken.push_back(combination.name + ": the intervals that it certifies miss by " +
                       number_text(combination.certified->worst) + " of the largest distance what must hold");
    if (combination.guarantee.held == false) broken.push_back(combination.name + ": " + combination.guarantee.why);
  }
  return broken;
}

}  // namespace geodrome
