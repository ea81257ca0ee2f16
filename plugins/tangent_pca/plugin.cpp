// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/tangent_pca/pca_tangents.hpp"

GEODROME_PLUGIN(geodrome::PcaTangents, .name = "pca",
                .summary = "least-squares plane of the k nearest points (principal components)", .licence = "MIT",
                .options = geodrome::pca_options)
