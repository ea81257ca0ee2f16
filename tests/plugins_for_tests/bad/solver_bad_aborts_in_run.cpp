// SPDX-License-Identifier: MIT
// Fails an assertion while computing.
#undef NDEBUG
#include <cassert>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { assert(!"the queue is sorted"); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_aborts_in_run", .summary = "a bad plugin",
                .licence = "MIT")
