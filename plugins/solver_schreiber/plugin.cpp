// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "plugins/solver_schreiber/schreiber.hpp"

GEODROME_PLUGIN(geodrome::SchreiberSolver, .name = "schreiber",
                .summary = "exact, by whole wavefronts (Schreiber 2010)", .licence = "MIT",
                .provides = geodrome::SchreiberSolver::provides, .factor = geodrome::exact_factor)
