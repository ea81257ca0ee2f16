// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "engine/run/open_input.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// "project", "insert", "printed": how options and reports name it.
std::string_view name(QueryRule rule);

/// What distances of this rule do not promise, in one sentence for the report; empty for `project`.
std::string_view caveat(QueryRule rule);

/// Throws OptionError if the rule means nothing for this input or these sources, CapabilityError, naming the
/// reconstructor, if that cannot insert points.
void check_query(QueryRule rule, const Opened& opened, std::span<const Query> sources);

}  // namespace geodrome
