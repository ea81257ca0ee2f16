// SPDX-License-Identifier: MIT
// Distances that are a billionth too long where searches are prepared together.
#include "tests/plugins_for_tests/faulty/planned_solver.hpp"

namespace {
struct Longer : geodrome::faulty::NoFault {
  static double value(double right) { return 1.000000001 * right; }
};
constexpr geodrome::ManySearches planned{geodrome::faulty::planned_by<Longer>};
}  // namespace

GEODROME_PLANNED_SOLVER(planned, "faulty_planned_long")
