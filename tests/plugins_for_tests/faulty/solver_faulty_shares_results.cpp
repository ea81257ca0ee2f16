// SPDX-License-Identifier: MIT
// All searches of a surface write their results into one array: right on one thread, wrong on two.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
struct Fault : geodrome::faulty::NoFault {
  static constexpr bool shares_results = true;
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_shares_results")
