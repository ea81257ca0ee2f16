// SPDX-License-Identifier: MIT
// The distances of an exact solver as their own lower bounds, also where they are infinite because of a limit.
#include "tests/plugins_for_tests/faulty/bounded_solver.hpp"

namespace {
double itself(const geodrome::Distance& distance) { return distance.value; }
constexpr const auto& bounds = geodrome::faulty::bounds_by<itself>;
}  // namespace

GEODROME_BOUNDED_SOLVER(bounds, "faulty_bounds_beyond")
