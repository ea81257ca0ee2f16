// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_aleksandrov/aleksandrov.hpp"

GEODROME_PLUGIN(geodrome::AleksandrovSolver, .name = "aleksandrov",
                .summary = "within a factor of 1 + delta, by Steiner points (Aleksandrov, Maheshwari and Sack 2005)",
                .licence = "MIT", .provides = geodrome::AleksandrovSolver::provides,
                .options = geodrome::AleksandrovSolver::options, .factor = geodrome::AleksandrovSolver::factor)
