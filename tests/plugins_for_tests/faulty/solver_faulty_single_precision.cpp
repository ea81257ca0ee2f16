// SPDX-License-Identifier: MIT
// Distances pass through float.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
struct Fault : geodrome::faulty::NoFault {
  static double value(double right) { return static_cast<float>(right); }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_single_precision")
