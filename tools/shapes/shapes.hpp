// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/geometry.hpp"
#include "geodrome/surface.hpp"

/// Shapes that Geodrome generates itself: for tours, tests and benchmarks. Same arguments, same bytes.
namespace geodrome::shapes {

enum class Sampling { uniform, blue, grid };

struct SampleSpec {
  std::size_t points = 2000;
  Sampling sampling = Sampling::uniform;  ///< uniform by area; blue noise; a lattice (its count is near `points`)
  double noise = 0;                       ///< standard deviation along the normal, share of the bounding box's diagonal
  std::uint64_t seed = 1;
};

/// Names of the kinds that can be sampled, and of those that can be meshed.
const std::vector<std::string>& sample_kinds();
const std::vector<std::string>& mesh_kinds();

/// Points on sphere (radius 1), ellipsoid (1, 0.8, 0.6), torus (R = 1, r = 0.4, about the z axis), genus2, genus5, trefoil (a tube), plane (unit square),
/// cut-sphere, cut-torus (the part below a plane). Uniform and blue give exactly `spec.points` points, pairwise distinct.
/// Throws OptionError for an unknown kind or fewer than 4 points.
PointSample sample(const std::string& kind, const SampleSpec& spec);

/// A mesh with about `faces` faces of a kind of `sample`, or icosphere, jittered-torus, noisy-sphere, bumpy; oriented
/// outwards, closed unless the kind is cut or a plane. Throws OptionError for an unknown kind.
SurfaceMesh mesh(const std::string& kind, std::size_t faces, std::uint64_t seed = 1);

}  // namespace geodrome::shapes
