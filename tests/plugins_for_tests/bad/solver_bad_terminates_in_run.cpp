// SPDX-License-Identifier: MIT
// Lets an exception run out of a thread of its own.
#include <stdexcept>
#include <thread>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
void on_run() {
  std::thread([] { throw std::runtime_error("thread lost its way"); }).join();
}
}  // namespace

GEODROME_PLUGIN(geodrome::bad::StraightSolver<on_run>, .name = "bad_terminates_in_run", .summary = "a bad plugin",
                .licence = "MIT")
