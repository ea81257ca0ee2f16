// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// Moves places from the closest points of one surface to those of another that a local change made of it; bitwise the
/// places that a SurfaceLocator of the new surface would find. Places that are not on the surface stay as they are.
///
/// `from`: where the places are, with its locator; `to`: its vertices, and more behind them. Faces are compared index
/// by index. O(F + t) and O(log F) for every place near the change; O(F log F + t log F) if over 1000 faces differ.
void relocate(std::span<NamedPoint> places, const SurfaceMesh& from, const SurfaceLocator& locator, const MeshPtr& to);

}  // namespace geodrome
