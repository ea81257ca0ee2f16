// SPDX-License-Identifier: MIT
// Lower bounds that are a millionth too long.
#include "tests/plugins_for_tests/faulty/bounded_solver.hpp"

namespace {
double too_long(const geodrome::Distance& distance) { return 1.000001 * distance.value; }
constexpr const auto& bounds = geodrome::faulty::bounds_by<too_long>;
}  // namespace

GEODROME_BOUNDED_SOLVER(bounds, "faulty_long_bounds")
