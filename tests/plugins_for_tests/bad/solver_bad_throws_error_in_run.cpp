// SPDX-License-Identifier: MIT
// Throws an error of Geodrome while computing.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { throw geodrome::NumericalError("two windows overlap"); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_throws_error_in_run", .summary = "a bad plugin",
                .licence = "MIT")
