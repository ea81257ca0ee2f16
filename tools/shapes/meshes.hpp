// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/surface.hpp"
#include "tools/shapes/patch.hpp"
#include "tools/shapes/radial.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::shapes {

/// The grid of a patch with about `faces` faces. With `jitter`, every (u, v) is moved by up to 0.3 of the spacing in
/// each parameter; the patch must wrap both ways then.
SurfaceMesh patch_mesh(const Patch& patch, std::size_t faces, Random* jitter = nullptr);

/// The icosahedron, each face cut into four k times, vertices on the unit sphere; of the counts 20 x 4^k, the one
/// nearest to `faces` by ratio.
SurfaceMesh icosphere(std::size_t faces);

/// The icosphere, vertex p at radius 1 + 0.5 h u, h the mean length of the icosphere's edges, u uniform in [-1, 1).
SurfaceMesh noisy_sphere(std::size_t faces, Random& random);

/// The icosphere, its vertices moved along their directions.
SurfaceMesh radial_mesh(const Radial& body, std::size_t faces);

/// Sum of the areas of the faces.
double area(const SurfaceMesh& mesh);

}  // namespace geodrome::shapes
