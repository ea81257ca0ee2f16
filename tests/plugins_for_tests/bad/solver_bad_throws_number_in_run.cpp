// SPDX-License-Identifier: MIT
// Throws what is no exception while computing.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { throw 42; }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_throws_number_in_run", .summary = "a bad plugin",
                .licence = "MIT")
