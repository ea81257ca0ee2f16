// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/formats/text.hpp"
#include "geodrome/engine/observer.hpp"
#include "geodrome/engine/remedies.hpp"

namespace geodrome {

/// A finding for people: its message, then the elements that it names in brackets, "..." if there are more of them.
inline std::string message_of(const Finding& finding) {
  std::string elements;
  for (const Index element : finding.elements) append_word(elements, std::to_string(element));
  if (elements.empty()) return finding.message;
  return finding.message + " [" + elements + (finding.elements.size() < finding.count ? ", ...]" : "]");
}

/// A finding for people: as `message_of`, then its remedy in the words of the observer.
inline std::string text_of(const Finding& finding, const Observer& observer) {
  std::string text = message_of(finding);
  if (finding.remedy.empty()) return text;
  if (text.ends_with('.')) text.pop_back();
  return text + "; " + observer.words(finding.remedy);
}

/// An error for people: as its `what`, with the remedy in the words of the observer.
inline std::string text_of(const Error& error, const Observer& observer) {
  return text_of(error, observer.words(error.coded_remedy()));
}

}  // namespace geodrome
