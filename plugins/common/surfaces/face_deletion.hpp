// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// Returns the faces of an oriented manifold without the `doomed` ones (ascending). Smaller fans are deleted as well
/// where the remaining faces meet in a single vertex, so that the result is a manifold: the largest fan stays (ties:
/// the one with the lowest face). The order of the faces stays. O(F).
std::vector<Triangle> without_faces(const std::vector<Triangle>& faces, std::span<const Index> doomed,
                                    std::size_t vertex_count);

}  // namespace geodrome
