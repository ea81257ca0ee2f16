// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace geodrome {

/// The question that distances of some accuracy are for.
enum class Asked {
  searches,  ///< rows, the nearest source, paths
  pairs      ///< a pair oracle
};

/// Returns the solver for an accuracy, as `StageChoice::solver` takes it. "exact": chen_han. A number delta from 1e-6
/// to 1, for distances that are at most 1 + delta times too long and never too short: merged_windows. Of pair oracles
/// none is exact, and a number is from 1e-4 to 1: aleksandrov. Throws OptionError for anything else.
std::string solver_of_accuracy(const std::string& accuracy, Asked asked = Asked::searches);

}  // namespace geodrome
