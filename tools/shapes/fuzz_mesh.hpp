// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "geodrome/surface.hpp"

namespace geodrome::shapes {

struct FuzzMesh {
  SurfaceMesh mesh;
  std::string recipe;  ///< base shape and mutations, for people: "terrain, holes 3, scale 1e-06"
};

/// A random mesh of 60 to 4,000 faces, half of them below 900: a base shape (smooth, noisy, flat, symmetric, open, of
/// higher genus), none to several mutations, in this order:
///
///   second shape   not connected with the first
///   stretch        every axis by its own factor, up to 100
///   jitter         vertices by up to 0.3 of the mean edge
///   needles        vertices pulled to an opposite edge, or along an edge to its other end: all but 1e-1 to 1e-9 of the
///                  way; one in eight lands exactly on the edge, so that faces have no area
///   holes          single faces deleted such that manifolds stay manifold, or all faces around a vertex
///   touching fans  faces deleted until fans meet at vertices alone
///   bow-ties       pairs of vertices that share no neighbour merged into one
///   renumbering    faces and their corners in another order
///   scale          1e-6 or 1e6, or a place 100 extents from the origin
///
/// Every edge has at most two faces, which run along it in opposite directions; vertices may have several fans, faces
/// may fold over and cut each other, vertices may be on no face. Same seed, same bytes.
FuzzMesh fuzz_mesh(std::uint64_t seed);

}  // namespace geodrome::shapes
