// SPDX-License-Identifier: MIT
// Never ends, and never asks whether it should.
#include <chrono>
#include <thread>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() {
  for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_hangs_in_run", .summary = "a bad plugin",
                .licence = "MIT")
