// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/control_function.hpp"
#include "plugins/common/parallel_for.hpp"

namespace geodrome {

/// Boundaries with fewer points cannot be told from thin places of a sample: a hole of five edges across has some
/// twenty.
inline constexpr std::size_t least_boundary = 20;

/// Finds where a sample shows the boundary of a sheet: rims of open sheets, holes, slits. Returns, per point of
/// `sample`, the spacing around it if it lies on a boundary, and 0 if not. The spacing is the lower quartile of phi
/// among its 64 nearest points: 0.7 steps of a lattice, 0.9 of the mean distance in a uniform sample.
///
/// A point may lie on one if its planar cell has no end or reaches over twice the spacing, and twice the same quartile
/// among its 17 nearest points: of a uniform sample of a closed surface one point in a hundred does, in groups of a
/// few. So only groups of at least `least_boundary` such points count, each within four spacings of the next; and with
/// these, points whose phi is large for their neighbourhood within 2.5 spacings. Only points that the control function
/// states as capped or unbounded are looked at: where it states none, none is found.
///
/// `context` gives threads and takes progress. O(n log n).
std::vector<double> boundary_spacing(const PointSample& sample, const Control& control, RunContext& context,
                                     ProgressShare share);

}  // namespace geodrome
