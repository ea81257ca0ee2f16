// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "geodrome/geometry.hpp"
#include "tools/shapes/patch.hpp"

namespace geodrome::shapes {

/// Points of the sheets among the patches (see patch.hpp).
PatchPoint on_swiss_roll(double u, double v);
PatchPoint on_s_curve(double u, double v);
PatchPoint on_slit_pipe(double u, double v);

/// A place on a sheet unrolled into the plane.
struct UnrolledPoint {
  double along = 0, across = 0;
};

/// The kinds that can be unrolled without stretching, into a rectangle: distances in them are straight lines there.
const std::vector<std::string>& sheet_kinds();

/// Unrolls the point of a sheet that is nearest to `p`, to first order. Throws OptionError for another kind.
UnrolledPoint unrolled(const std::string& kind, const Vec3& p);

/// The distance in a sheet between two of its points: exact.
double sheet_distance(const std::string& kind, const Vec3& a, const Vec3& b);

}  // namespace geodrome::shapes
