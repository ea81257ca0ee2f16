// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/surface.hpp"
#include "tools/shapes/random.hpp"

/// Random points of a surface, as sources and targets of benchmarks. Precondition of all: the mesh has a face. Faces
/// are drawn evenly, whatever their size.
namespace geodrome::bench {

SurfacePoint random_vertex(const SurfaceMesh& mesh, shapes::Random& random);
SurfacePoint random_inner_point(const SurfaceMesh& mesh, shapes::Random& random);
SurfacePoint random_edge_point(const SurfaceMesh& mesh, shapes::Random& random);

}  // namespace geodrome::bench
