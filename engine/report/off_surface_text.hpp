// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include "engine/report/json.hpp"
#include "engine/surface/off_surface.hpp"

/// Points that were named off the surface, as users are told of them. Where none is off, nothing is told.
namespace geodrome {

/// A warning, if there is something to warn of.
std::vector<Finding> findings_of(const OffSurface& off);

/// The member "places_off_surface" of reports, with the warning as its "findings".
void add_off_surface(Json& json, const OffSurface& off);

/// The line "places" of summaries.
void summarize(const OffSurface& off, std::ostream& out);

}  // namespace geodrome
