// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/compare/surfaces.hpp"

namespace geodrome {

/// Cuts every face in 4 by the middles of its edges. The surface stays the same: vertices keep their numbers, each
/// face's parts its weight, and every distance stays what it is up to the rounding of the new coordinates. Any mesh.
/// O(F log F).
SurfaceMesh cut_in_four(const SurfaceMesh& mesh);

/// Where a point of a mesh lies on that mesh `cut_in_four`.
SurfacePoint on_quarter(const SurfacePoint& point);

/// A compared mesh with its faces cut in 4, and the same sources and targets on it.
std::shared_ptr<const ComparedSurface> refined(const ComparedSurface& coarse);

}  // namespace geodrome
