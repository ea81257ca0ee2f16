// SPDX-License-Identifier: MIT
// Its constructor throws.
#include <stdexcept>

#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {
class Solver : public geodrome::bad::StraightSolver<> {
 public:
  Solver() { throw std::runtime_error("table of weights not found"); }
};
}  // namespace

GEODROME_PLUGIN(Solver, .name = "bad_throws_in_create", .summary = "a bad plugin", .licence = "MIT")
