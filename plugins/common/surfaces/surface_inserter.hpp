// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "geodrome/surface_reconstructor.hpp"

namespace geodrome {

/// The inserter that reconstructors offer: `with` finds the closest point of the surface (R-tree), re-triangulates
/// there (`insert_point`) and copies the rest. Faces that stay keep their index. A sample point within 1e-9 of the
/// longest edge of its closest face from a vertex is that vertex. Errors of `with`: SampleError for a point that is not
/// there or not finite.
///
/// `mesh`: an oriented manifold with a face, without face weights; `sample_of_vertex` as in Reconstruction; `sample`:
/// as stage 4 got it. O(F log F + n); `with`: O(F log F), of which all but some 10 microseconds is the new mesh's
/// connectivity.
std::unique_ptr<PointInserter> make_inserter(MeshPtr mesh, const std::vector<Index>& sample_of_vertex,
                                             const PointSample& sample);

}  // namespace geodrome
