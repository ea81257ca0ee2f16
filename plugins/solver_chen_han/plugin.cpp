// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_chen_han/chen_han.hpp"

GEODROME_PLUGIN(geodrome::ChenHanSolver, .name = "chen_han",
                .summary = "exact, by windows (Chen and Han 1996, Xin and Wang 2009, Qin et al. 2016)",
                .licence = "MIT", .provides = geodrome::ChenHanSolver::provides,
                .options = geodrome::ChenHanSolver::options, .factor = geodrome::exact_factor)
