// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"
#include "solver_schreiber/schreiber.hpp"

GEODROME_PLUGIN(geodrome::SchreiberSolver, .name = "schreiber",
                .summary = "by whole wavefronts (Schreiber 2010); being completed: no guarantee yet", .licence = "MIT",
                .provides = geodrome::SchreiberSolver::provides)
