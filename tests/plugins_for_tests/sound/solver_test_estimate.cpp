// SPDX-License-Identifier: MIT
// A good one that promises nothing: its distances may be too short as well as too long.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

GEODROME_PLUGIN(geodrome::bad::StraightSolver<>, .name = "test_estimate", .summary = "straight through space",
                .licence = "MIT", .provides = geodrome::Provides::start_distances)
