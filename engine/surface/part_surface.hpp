// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// Cuts a surface that stages made of a sample, or of some of its points, down to the part that the sample shows, and
/// puts every other point off it; `surface.part` says what went. Returns false, with nothing changed, if no part is
/// left.
///
/// The reach of a sample point is three times the spacing around it (the side of the square that each of its 8 nearest
/// has), at least five sigma of the noise. A face stays if every place on it has a sample point within that point's
/// reach, so no hole of the sample is spanned; of what shared edges then connect, the piece with most points near
/// stays; a point is on it if it is the nearest piece and lies within the point's reach and its psi. A vertex where
/// several fans of faces are left becomes one for each. The inserter is lost unless all faces stay. O(n log n + F log
/// F).
bool cut_to_part(const Input& input, PlacedSurface& surface);

/// Whether a place on a cut surface, named by a point in space, is as near to it as a point of the sample must be.
bool within_reach(const PlacedSurface& surface, const SurfacePoint& at, const Vec3& position);

}  // namespace geodrome
