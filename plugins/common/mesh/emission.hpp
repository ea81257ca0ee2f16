// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"

namespace geodrome {

/// Lists the faces into which a vertex with this label sends windows, each as the half-edge that starts at the vertex:
/// all for a source and where the surface is irregular; at a saddle those with directions that make an angle of at
/// least pi, on both sides, with the path that came in; none at a smooth vertex. Replaces `out`. O(degree).
void corners_that_emit(const PackedMesh& surface, Index vertex, const Label& label, std::vector<Index>& out);

}  // namespace geodrome
