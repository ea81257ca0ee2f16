// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/figures.hpp"

#include "engine/formats/number_text.hpp"
#include "engine/report/median.hpp"

namespace geodrome {

double SearchCost::median_seconds() const { return source_seconds.empty() ? 0 : median(source_seconds); }

double SmoothComparison::median_seconds() const { return source_seconds.empty() ? 0 : median(source_seconds); }

namespace {

void add_failing(const std::string& name, const std::vector<NamedCheck>& invariants, std::vector<std::string>& broken) {
  for (const auto& [what, check] : invariants)
    if (!check.holds())
      broken.push_back(name + ": " + what + " fails " + std::to_string(check.violated) + " times of " +
                       std::to_string(check.tested));
}

}  // namespace

std::vector<std::string> broken_promises(const ComparisonFigures& figures) {
  std::vector<std::string> broken;
  for (const CombinationFigures& combination : figures.combinations) {
    if (!combination.ran()) continue;
    add_failing(combination.name, combination.invariants, broken);
    if (combination.smooth) add_failing(combination.name + ", smooth", combination.smooth->invariants, broken);
    if (combination.certified && !combination.certified->hold())
      broken.push_back(combination.name + ": the intervals that it certifies miss by " +
                       number_text(combination.certified->worst) + " of the largest distance what must hold");
    if (combination.guarantee.held == false) broken.push_back(combination.name + ": " + combination.guarantee.why);
  }
  return broken;
}

}  // namespace geodrome
