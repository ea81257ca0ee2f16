// SPDX-License-Identifier: MIT
// Every distance is too long by a millionth.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
struct Fault : geodrome::faulty::NoFault {
  static double value(double right) { return right * (1 + 1e-6); }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_a_millionth")
