// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

/// The numbers of a matrix, or of the coordinates of a mesh, in a file.
enum class ScalarType { float64, float32 };

}  // namespace geodrome
