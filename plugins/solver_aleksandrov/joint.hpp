// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"

namespace geodrome::aleksandrov {

/// Points that lead from a place of one face of the flat surface into `face`, which holds that place too up to
/// rounding: each and the next are in one face, the first in that of `at`, the last in `face`. One point if both faces
/// have an edge in common there or a vertex; more through faces without area, or needles, between them. All are within
/// rounding of `at`. Throws NumericalError if nothing leads there. O(k log k) for the k faces at the place.
std::vector<SurfacePoint> joint(const PackedMesh& surface, const SurfacePoint& at, Index face);

}  // namespace geodrome::aleksandrov
