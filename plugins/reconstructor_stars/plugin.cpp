// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/reconstructor_stars/star_surface.hpp"

GEODROME_PLUGIN(geodrome::StarSurface, .name = "stars",
                .summary = "the paper's surface as printed: the union of the planar stars (Section 2.3), or a refusal",
                .licence = "MIT", .options = geodrome::StarSurface::options)
