// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/solver_schreiber/generator.hpp"

namespace geodrome::schreiber {

/// Returns a lower bound of the distance at which `g` dies between its neighbours (nullptr: none on that side). All are
/// in one frame, with the wavefront above the line y = 0. The bound is proved by a witness, a ray of g and the distance
/// up to which neither neighbour is nearer on it; so no case that is missed or rounded can make it too large, beyond
/// `same_line` (lifetime.cpp).
double lifetime(const Generator* left, const Generator& g, const Generator* right);

}  // namespace geodrome::schreiber
