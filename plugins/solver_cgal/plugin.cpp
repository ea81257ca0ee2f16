// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodrome/plugin.hpp"
#include "plugins/solver_cgal/cgal_solver.hpp"

GEODROME_PLUGIN(geodrome::CgalSolver, .name = "cgal",
                .summary = "exact, CGAL Surface_mesh_shortest_path (Xin and Wang 2009)", .licence = "GPL-3.0-or-later",
                .needs = geodrome::CgalSolver::needs, .provides = geodrome::CgalSolver::provides,
                .factor = geodrome::exact_factor)
