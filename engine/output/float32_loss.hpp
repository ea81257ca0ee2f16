// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "geodrome/finding.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// A warning if rounding coordinates to float32 moves vertices of a mesh by more than is small against its edges, or
/// lets vertices at different places fall together, with the number of faces that collapse then. `file`: where it is
/// written. O(V log V + F).
std::vector<Finding> float32_loss(const std::filesystem::path& file, const SurfaceMesh& mesh);

}  // namespace geodrome
