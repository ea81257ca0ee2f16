// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/run_context.hpp"
#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"

namespace geodrome::aleksandrov {

/// Flips edges from a stack until none of them, and none of those around a flip, is to be flipped. The stack is empty
/// afterwards; appends the faces that changed, some of them repeatedly. May throw Cancelled.
void flip_until_delaunay(IntrinsicTriangulation& triangulation, std::vector<Index>& stack, std::vector<Index>& changed,
                         const RunContext& context);

/// Flips edges until all are Delaunay: until the angles opposite to an edge that can be flipped have no sum above pi.
/// Thin faces with a large angle go, and of all triangulations with these vertices this one has the largest smallest
/// angle wherever it is flat. May throw Cancelled. O(F) flips as a rule.
void make_delaunay(IntrinsicTriangulation& triangulation, const RunContext& context);

/// Inserts vertices until no angle is below `least_angle` (radians, up to pi / 7), but for those that the surface
/// itself has: at a vertex with a total angle below pi / 3, and between edges that cannot be flipped. Ruppert's
/// refinement (1995) on a surface, worst face first; the triangulation stays Delaunay. Stops at
/// `most` inserted vertices: faces may be thin then, which costs time and spoils nothing. Precondition: Delaunay.
/// Returns the number of vertices inserted. May throw Cancelled.
Index refine(IntrinsicTriangulation& triangulation, double least_angle, Index most, const RunContext& context);

}  // namespace geodrome::aleksandrov
