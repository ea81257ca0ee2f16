// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/control_lipschitz/lipschitz_control.hpp"

GEODROME_PLUGIN(geodrome::LipschitzControl, .name = "lipschitz",
                .summary = "planar Voronoi cells and their Lipschitz envelope (Theorem 3, equation (1))",
                .licence = "MIT", .options = geodrome::lipschitz_options)
