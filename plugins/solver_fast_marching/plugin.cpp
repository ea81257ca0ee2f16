// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_fast_marching/fast_marching.hpp"

GEODROME_PLUGIN(geodrome::FastMarching, .name = "fast_marching",
                .summary = "an estimate in near-linear time (Kimmel and Sethian 1998), on any mesh", .licence = "MIT",
                .provides = geodrome::FastMarching::provides)
