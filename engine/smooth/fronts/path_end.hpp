// SPDX-License-Identifier: MIT
#pragma once

#include "engine/smooth/fronts/edge_curves.hpp"
#include "engine/smooth/fronts/front_point.hpp"
#include "engine/smooth/shortening.hpp"

namespace geodrome {

/// What a shortened path, from a point to the source, lets know of the distance at the point: by the last run of
/// `shortening`, whose path `path` it is. Marching goes on from vertices only, and where all of the path is smooth.
FrontPoint front_at_end(const EdgeCurves& curves, Shortening& shortening, std::size_t path, Index vertex);

}  // namespace geodrome
