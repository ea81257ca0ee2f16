// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/tangent_jet/jet_tangents.hpp"
#include "plugins/tangent_jet/smooth/smooth_fit.hpp"

namespace geodrome {
namespace {

constexpr SmoothFit smooth_fit{&fit_smooth_surface};

}  // namespace
}  // namespace geodrome

GEODROME_PLUGIN(geodrome::JetTangents, .name = "jet",
                .summary = "quadric fit over the least-squares plane; smooths noise, drops outliers", .licence = "MIT",
                .options = geodrome::jet_options, .extension = geodrome::extensions<geodrome::smooth_fit>)
