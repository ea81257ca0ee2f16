// SPDX-License-Identifier: MIT
// Throws while computing.
#include <stdexcept>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() { throw std::runtime_error("wavefront is empty"); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_throws_in_run", .summary = "a bad plugin",
                .licence = "MIT")
