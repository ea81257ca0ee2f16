// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodrome/plugin.hpp"
#include "plugins/solver_heat/heat.hpp"

GEODROME_PLUGIN(geodrome::Heat, .name = "heat",
                .summary = "an estimate by two linear systems, factored once (Crane et al. 2013), CGAL Heat_method_3",
                .licence = "GPL-3.0-or-later", .needs = geodrome::Heat::needs, .provides = geodrome::Heat::provides)
