// SPDX-License-Identifier: MIT
// Offers an extension, whose functions know the plugin's own class behind the interface.
#include "tests/plugins_for_tests/sound/greeting.hpp"
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {

struct Solver : geodrome::bad::StraightSolver<> {
  int loudness = 3;
};

constexpr geodrome::test::Greeting greeting{[](const geodrome::ShortestPathSolver& solver, int times) noexcept {
  return static_cast<const Solver&>(solver).loudness * times;
}};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "test_extended", .summary = "straight through space", .licence = "MIT",
                .extension = geodrome::extensions<greeting>)
