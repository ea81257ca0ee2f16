// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/surface.hpp"
#include "tools/shapes/implicit.hpp"

namespace geodrome::shapes {

/// A mesh of an implicit surface with about `faces` faces, but never coarser than the surface's `coarsest` cells:
/// closed, manifold, oriented outwards, its vertices on the surface. Surface nets (Gibson 1998) on a grid of cubes,
/// then Newton.
SurfaceMesh surface_net(const Implicit& surface, std::size_t faces);

/// Appends the two triangles of the quad a, b, c, d, cut along the shorter diagonal (along a, c if they are equal up to
/// rounding, so that regular grids stay regular).
void split_quad(const std::vector<Vec3>& positions, Index a, Index b, Index c, Index d, std::vector<Triangle>& out);

}  // namespace geodrome::shapes
