// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace geodrome {

/// "1 face", "2 faces".
inline std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Appends a word to a list of them, after a comma if it is not the first.
inline void append_word(std::string& list, const std::string& word) { list += (list.empty() ? "" : ", ") + word; }

/// The words of a range with commas between them.
template <class Words>
std::string joined(const Words& words) {
  std::string list;
  for (const auto& word : words) append_word(list, word);
  return list;
}

}  // namespace geodrome
