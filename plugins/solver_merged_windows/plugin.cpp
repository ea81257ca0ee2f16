// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_merged_windows/merged_windows.hpp"

GEODROME_PLUGIN(geodrome::MergedWindowsSolver, .name = "merged_windows",
                .summary = "within a factor of 1 + delta, by merged windows (after Surazhsky et al. 2005)",
                .licence = "MIT", .provides = geodrome::MergedWindowsSolver::provides,
                .options = geodrome::MergedWindowsSolver::options, .factor = geodrome::MergedWindowsSolver::factor)
