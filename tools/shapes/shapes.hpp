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
  double jitter = 0;  ///< lattice points move by up to this share of a step in either parameter, below 1/2
};

/// Names of the kinds that can be sampled, and of those that can be meshed.
const std::vector<std::string>& sample_kinds();
const std::vector<std::string>& mesh_kinds();

/// Points on sphere (radius 1), ellipsoid (1, 0.8, 0.6), torus (R = 1, r = 0.4, about the z axis), genus2, genus5,
/// trefoil (a tube), bumpy and star (star-like bodies), plane (unit square), cut-sphere, cut-torus (the part below a
/// plane), swiss-roll, s-curve, slit-pipe (sheets: see sheets.hpp); patch.hpp, radial.hpp and implicit.hpp give the
/// constants. Uniform and blue give exactly `spec.points` points, independent and exactly uniform by area, or spread by
/// sample elimination from five times as many. The lattice of genus2 and genus5 has at least 588 and 1504 points. Noise
/// is along the true normal; the box is that of the points without noise. Throws OptionError for an unknown kind, fewer
/// than 4 points, noise that is not a finite number >= 0, or jitter of a lattice of genus2 or genus5.
PointSample sample(const std::string& kind, const SampleSpec& spec);

/// A mesh with about `faces` faces of a kind of `sample`, or icosphere, jittered-torus, noisy-sphere; manifold,
/// oriented outwards, closed unless the kind is cut or a plane. Spheres from the icosahedron have the nearest of
/// 20 x 4^k faces; genus2 and genus5 never fewer than 1180 and 3024, for holes to show. The vertices lie on the
/// surface. `seed` matters to jittered-torus and noisy-sphere. Throws OptionError for an unknown kind.
SurfaceMesh mesh(const std::string& kind, std::size_t faces, std::uint64_t seed = 1);

}  // namespace geodrome::shapes
