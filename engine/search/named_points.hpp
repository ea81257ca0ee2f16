// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/surface/selection.hpp"

/// Where the points that users name lie: the second step of `select`, after `parse_selection`.
namespace geodrome {

/// The places of a list, those of points `x y z` settled as rows are where distances are smooth (`settle_places`).
/// Throws for a row or face that is not there: InputError naming file and line, OptionError for a list in the text
/// itself. O(entries), a search of the closest point for each position, and O(F) once where there are any and distances
/// are smooth.
std::vector<NamedPoint> resolve(const Selection& selection, const Input& input, const PlacedSurface& surface);
PairList resolve(const PairSelection& selection, const Input& input, const PlacedSurface& surface);

/// Throws InputError, naming the point, the place and a row that would do, for a point that was named and is not on the
/// part of the sample that the surface is of. `where`: what the message begins with.
void demand_on_part(const NamedPoint& point, const PlacedSurface& surface, const std::string& where);
/// The same for all points of a list that names them; "all" names none.
void demand_on_part(const Selection& selection, std::span<const NamedPoint> points, const PlacedSurface& surface);

}  // namespace geodrome
