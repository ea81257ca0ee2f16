// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodrome/plugin.hpp"

#include "plugins/tangent_pole/pole_tangents.hpp"

GEODROME_PLUGIN(geodrome::PoleTangents, .name = "pole",
                .summary = "direction to the Voronoi pole (Amenta and Bern 1999), the paper's choice",
                .licence = "GPL-3.0-or-later")
