// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "geodrome/conformance.hpp"

/// How `geodrome-judge` tells a verdict to the process that asked.
namespace geodrome::conformance {

nlohmann::json to_json(const Verdict& verdict);

/// Throws nlohmann's exceptions for what is no verdict.
Verdict verdict_from_json(const nlohmann::json& json);

}  // namespace geodrome::conformance
