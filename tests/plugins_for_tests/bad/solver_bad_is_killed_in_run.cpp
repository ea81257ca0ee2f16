// SPDX-License-Identifier: MIT
// Is killed while computing, as by a system that is out of memory.
#include <csignal>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { std::raise(SIGKILL); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_is_killed_in_run", .summary = "a bad plugin",
                .licence = "MIT")
