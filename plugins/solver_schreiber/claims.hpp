// SPDX-License-Identifier: MIT
#pragma once

#include "plugins/common/exact/ordered_pair.hpp"
#include "plugins/solver_schreiber/generator.hpp"

namespace geodrome::schreiber {

/// Returns the claim of a generator: the part of a half-edge of `length` that its rays cross.
inline Interval claim_of(const Generator& g, double length) { return {g.low(length), g.high(length)}; }

/// Shrink the claim of a generator to the part of the half-edge where it was not farther, up to rounding, than its
/// neighbour that is removed. The part that the neighbour did not claim stays.
void keep_left(const Generator& left, Interval& l, const Generator& gone, const Interval& r);
void keep_right(const Generator& gone, const Interval& l, const Generator& right, Interval& r);

/// Tells whether a point is on the right of the boundary between neighbours in order. A point beyond the rays of both
/// lies in a gap, which counts as part of the left one.
///
/// The nearer generator at a crossing decides if only one of the two has a ray to the point and that ray crosses the
/// other's wedge. The crossing also shows whether the ray is a real path: wedges inside a front are wider than the free
/// way between the vertices beside it, but the neighbour whose outermost ray passes such a vertex is nearer up to
/// there.
bool right_has(const Generator& left, const Generator& right, double px, double py);

}  // namespace geodrome::schreiber
