// SPDX-License-Identifier: MIT
// A counter is named as people write, not as the keys of a report.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
struct Fault : geodrome::faulty::NoFault {
  static void counters(std::vector<geodrome::Counter>& counters) { counters.front().name = "Windows created"; }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_counter_names")
