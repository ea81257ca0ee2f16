// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/formats/text.hpp"
#include "geodrome/finding.hpp"

namespace geodrome::input {

/// Counts an element; keeps its number if it is among the first ten.
inline void add_element(Finding& finding, Index element) {
  constexpr std::size_t kept = 10;
  if (finding.count++ < kept) finding.elements.push_back(element);
}

/// Files a finding that has counted something, with the rest of what is told.
inline void report(std::vector<Finding>& findings, Finding finding, Finding::Severity severity, std::string code,
                   std::string message) {
  if (finding.count == 0) return;
  finding.severity = severity, finding.code = std::move(code), finding.message = std::move(message);
  findings.push_back(std::move(finding));
}

}  // namespace geodrome::input
