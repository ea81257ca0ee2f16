// SPDX-License-Identifier: MIT
// Writes through a null pointer while computing.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_crashes_in_run", .summary = "a bad plugin",
                .licence = "MIT")
