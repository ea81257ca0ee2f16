// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace geodrome {

/// What the dynamic loader says. Boost wraps it in its own words and adds an errno that is somebody else's.
inline std::string loader_words(const std::string& text) {
  constexpr std::string_view before = "(dlerror system message: ";
  const std::size_t begin = text.find(before), end = text.rfind(')');
  if (begin == std::string::npos || end == std::string::npos || end < begin + before.size()) return text;
  return text.substr(begin + before.size(), end - begin - before.size());
}

}  // namespace geodrome
