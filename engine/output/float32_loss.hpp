// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "geodrome/finding.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// A warning if vertices of a mesh at different places fall together when their coordinates are rounded to float32,
/// with the number of faces that collapse. `file`: where it is written. O(V log V + F).
std::vector<Finding> float32_loss(const std::filesystem::path& file, const SurfaceMesh& mesh);

}  // namespace geodrome
