// SPDX-License-Identifier: MIT
// Recurses until the stack is full.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
int descend(volatile char* above) {
  volatile char here[4096];
  here[0] = above ? above[0] : 'x';
  return descend(here) + here[0];
}
void on_run() { descend(nullptr); }
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_overflows_in_run", .summary = "a bad plugin",
                .licence = "MIT")
