// SPDX-License-Identifier: MIT
// Ends the process while computing, as if all were well.
#include <cstdlib>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { std::_Exit(0); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_exits_in_run", .summary = "a bad plugin",
                .licence = "MIT")
