// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/tangent_jet/jet_tangents.hpp"

GEODROME_PLUGIN(geodrome::JetTangents, .name = "jet",
                .summary = "quadric fit over the least-squares plane; smooths noise, drops outliers", .licence = "MIT",
                .options = geodrome::jet_options)
