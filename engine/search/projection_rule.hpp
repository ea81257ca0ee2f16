// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "engine/surface/opened.hpp"
#include "geodrome/engine/distances.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// "project", "insert", "printed": how options and reports name it.
std::string_view name(ProjectionRule rule);

/// Returns what distances by this rule do not promise, in one sentence for the report; empty for `project`.
std::string_view caveat(ProjectionRule rule);

/// Throws OptionError if the rule means nothing for this input or these sources, CapabilityError, naming the
/// reconstructor, if that cannot insert points.
void check_rule(ProjectionRule rule, const Opened& opened, std::span<const NamedPoint> sources);

/// Throws OptionError unless it is a number >= 0.
void check_limit(double max_distance);

/// Throw OptionError for `printed`, which has no paths, and so no lower bounds.
void check_path_rule(ProjectionRule rule);
void check_bounds_rule(ProjectionRule rule);

}  // namespace geodrome
