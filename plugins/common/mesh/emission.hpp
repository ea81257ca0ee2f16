// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/mesh/labels.hpp"

namespace geodrome {

/// Lists the faces into which a vertex with this label sends windows, each as the half-edge that starts at the vertex:
/// all if the vertex is a source, irregular (PackedMesh::VertexKind), or labelled to emit to all sides; none at another
/// smooth vertex; at a saddle those with a direction that is at least a half turn from the path that came in, measured
/// either way; at an open saddle, on the boundary, those with one at least a half turn from it, measured within the
/// surface. The half turns are taken a little short, so a face too many may be listed. Replaces `out`. O(degree).
void corners_that_emit(const PackedMesh& surface, Index vertex, const Label& label, std::vector<Index>& out);

}  // namespace geodrome
