// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/compare/figures.hpp"
#include "engine/report/json.hpp"

namespace geodrome {

/// Schema "geodrome-comparison/1", which scripts and the page of a comparison read. What could not be
/// measured is null; so are errors of no pairs.
Json to_json(const ComparisonFigures& figures);

}  // namespace geodrome
