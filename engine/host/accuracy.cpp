// SPDX-License-Identifier: MIT
#include "geodrome/engine/accuracy.hpp"

#include "engine/formats/number_text.hpp"
#include "engine/formats/parse_number.hpp"
#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

namespace {

/// A solver with an option `delta`, and its range.
struct Approximation {
  const char* solver;
  double least, most;
};

constexpr Approximation by_search{"merged_windows", 1e-6, 1}, by_oracle{"aleksandrov", 1e-4, 1};

}  // namespace

std::string solver_of_accuracy(const std::string& accuracy, Asked asked) {
  const bool pairs = asked == Asked::pairs;
  if (accuracy == "exact") {
    if (!pairs) return StageChoice().solver;
    throw OptionError("no pair oracle is exact",
                      "name a number from " + number_text(by_oracle.least) + " on, or ask for rows of distances");
  }
  const Approximation& chosen = pairs ? by_oracle : by_search;
  const auto [delta, fault] = input::parse_number(accuracy);
  if (fault == input::NumberFault::none && delta >= chosen.least && delta <= chosen.most)
    return std::string(chosen.solver) + ":delta=" + number_text(delta);
  throw OptionError("the accuracy '" + accuracy + "' is none" + (pairs ? " of a pair oracle" : ""),
                    std::string(pairs ? "" : "say exact, or ") + "name a number from " + number_text(chosen.least) +
                        " to " + number_text(chosen.most) + ": distances are at most that share too long");
}

}  // namespace geodrome
