// SPDX-License-Identifier: GPL-3.0-or-later
#include "geodrome/plugin.hpp"
#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"

GEODROME_PLUGIN(
    geodrome::DelaunayCut, .name = "delaunay_cut",
    .summary = "minimal cut of the Delaunay tetrahedra between inside and outside, by tangent planes and planar stars",
    .licence = "GPL-3.0-or-later", .options = geodrome::DelaunayCut::options)
