// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "geodrome/many_searches.hpp"

namespace geodrome::chen_han {

/// Implements ManySearches by lists of direct paths (README.md, "Many rows").
std::unique_ptr<PreparedSurface> prepare_rows(const PreparedSurface& prepared, const SearchPlan& plan,
                                              RunContext& context);

}  // namespace geodrome::chen_han
