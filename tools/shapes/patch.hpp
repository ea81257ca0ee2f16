// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "geodrome/geometry.hpp"

namespace geodrome::shapes {

/// A point of a parametric surface. `area` points outwards; its length is the area of the surface per unit of (u, v).
struct PatchPoint {
  Vec3 position, area;
};

/// What happens where v ends: it goes round, the row shrinks to one point, or the surface ends.
enum class End { wrap, pole, border };

/// A surface parametrised over the unit square: u runs along, v across, so that du x dv points outwards.
///
/// sphere       radius 1
/// ellipsoid    semi-axes 1, 0.8, 0.6 along x, y, z
/// torus        R = 1, r = 0.4, axis z
/// trefoil      tube of radius 0.1 around (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t) / 3; the reach of that curve is
/// 0.20
///              (half the distance of its strands), its curvature is between 0.61 and 2.34
/// plane        the unit square in z = 0, normal +z
/// cut-sphere   the sphere where z <= 1/2: one border, a circle
/// cut-torus    the torus where z <= 1/5: two borders, circles
/// swiss-roll   (t cos t, 21 v, t sin t) with t = 1.5 pi (1 + 2 u): one turn and a half, 2 pi apart, 89.373 long
/// s-curve      (sin t, 2 v, sign(t) (cos t - 1)) with t = 3 pi (u - 1/2): 3 pi long
/// bumpy, star  see radial.hpp
/// slit-pipe    radius 1, 4 long, axis z, open at its ends, without a strip 0.75 wide along x > 0, y = 0
struct Patch {
  std::string_view kind;
  PatchPoint (*at)(double u, double v);  ///< u, v in [0, 1]
  bool u_wraps;
  End v_low, v_high;    ///< both wrap or none
  double largest_area;  ///< a bound of |area|, for rejection
  double aspect;        ///< length of the longest u-line over that of a v-line
};

/// The patch of a kind, or null.
const Patch* find_patch(std::string_view kind);

}  // namespace geodrome::shapes
