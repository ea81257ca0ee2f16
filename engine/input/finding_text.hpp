// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "geodrome/finding.hpp"

namespace geodrome {

/// A finding for people: its message, then the elements that it names in brackets, "..." if there are more of them.
inline std::string message_of(const Finding& finding) {
  std::string elements;
  for (const Index element : finding.elements) elements += (elements.empty() ? "" : ", ") + std::to_string(element);
  if (elements.empty()) return finding.message;
  return finding.message + " [" + elements + (finding.elements.size() < finding.count ? ", ...]" : "]");
}

/// The same with its remedy in the words of the library.
inline std::string text_of(const Finding& finding) {
  return message_of(finding) + (finding.remedy.empty() ? "" : "; " + finding.remedy.text);
}

}  // namespace geodrome
