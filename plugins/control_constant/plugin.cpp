// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/control_constant/constant_control.hpp"

GEODROME_PLUGIN(geodrome::ConstantControl, .name = "constant",
                .summary = "the same psi everywhere, given or from the sample's own spacing", .licence = "MIT",
                .options = geodrome::constant_options)
