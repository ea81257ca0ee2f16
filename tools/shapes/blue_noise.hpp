// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "geodrome/geometry.hpp"

namespace geodrome::shapes {

/// The indices, ascending, of `kept` of the points that are spread as evenly as their choice allows: weighted sample
/// elimination (Yuksel, "Sample elimination for generating Poisson disk sample sets", 2015; alpha 8, beta 0.65,
/// gamma 1.5). `area` is that of the surface the points lie on. Precondition: kept <= points.size().
/// O(n log n) for points that are uniform by area. Distances are taken in space. Ties go to the lower index.
std::vector<Index> eliminate(std::span<const Vec3> points, std::size_t kept, double area);

}  // namespace geodrome::shapes
