// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/jobs/compare/figures.hpp"

namespace geodrome {

/// A table with one line a combination, within 120 columns where names allow, then notes, then growth.
std::string text_of(const ComparisonFigures& figures);

}  // namespace geodrome
