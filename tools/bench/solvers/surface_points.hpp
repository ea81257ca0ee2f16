// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/surface.hpp"
#include "tools/shapes/random.hpp"

/// Random points of a surface, as sources and targets of benchmarks. Precondition of all: the mesh has a face. Faces
/// are drawn evenly, whatever their size.
namespace geodrome::bench {

SurfacePoint random_vertex(const SurfaceMesh& mesh, shapes::Random& random);
SurfacePoint random_inner_point(const SurfaceMesh& mesh, shapes::Random& random);
SurfacePoint random_edge_point(const SurfaceMesh& mesh, shapes::Random& random);

/// Sources of one search, of four kinds by `number`: 0, 4, ...: one at a vertex; 1: one inside a face; 2: one on an
/// edge; 3: two to five of these at once, some in the face of the one before, with start distances of 0 to three mean
/// edges, the first 0 and some of the others.
std::vector<Source> random_sources(const SurfaceMesh& mesh, std::size_t number, shapes::Random& random);

/// Whether a solver that provides `bits` takes these sources.
bool takes(Provides bits, const SurfaceMesh& mesh, std::span<const Source> sources);

}  // namespace geodrome::bench
