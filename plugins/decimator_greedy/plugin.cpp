// SPDX-License-Identifier: MIT
#include "geodrome/plugin.hpp"

#include "plugins/decimator_greedy/greedy_decimation.hpp"

GEODROME_PLUGIN(geodrome::GreedyDecimation, .name = "greedy",
                .summary = "keeps points whose psi balls do not hold each other (Algorithm 1)", .licence = "MIT")
