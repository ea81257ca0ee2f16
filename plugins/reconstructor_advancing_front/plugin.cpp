// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodrome/plugin.hpp"
#include "plugins/reconstructor_advancing_front/advancing_front.hpp"

GEODROME_PLUGIN(geodrome::AdvancingFront, .name = "advancing_front",
                .summary = "CGAL advancing front (Cohen-Steiner and Da 2004); planar samples by 2D Delaunay",
                .licence = "GPL-3.0-or-later", .options = geodrome::AdvancingFront::options)
