// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include "engine/report/json.hpp"
#include "engine/search/smooth_distances.hpp"

namespace geodrome {

Json to_json(const SmoothFigures& smooth);

/// The line of a summary on what became of flat paths. `of`: put before it, e.g. "nearest: ".
void summarize_smooth(const SmoothFigures& smooth, const FittedSurface& fitted, const char* of, std::ostream& out);

}  // namespace geodrome
