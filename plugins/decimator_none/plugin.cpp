// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/decimator_none/no_decimation.hpp"

GEODROME_PLUGIN(geodrome::NoDecimation, .name = "none", .summary = "keeps every point", .licence = "MIT")
