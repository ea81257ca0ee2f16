// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/engine/surface_report.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// Edges at each vertex. O(F log F).
std::vector<std::size_t> degrees_of(const SurfaceMesh& mesh);

/// O(F log F).
SurfaceFacts facts_of(const SurfaceMesh& mesh);

}  // namespace geodrome
