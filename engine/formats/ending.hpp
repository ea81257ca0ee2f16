// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <filesystem>
#include <string>
#include <string_view>

namespace geodrome {

inline std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// True if the file's name ends in `ending` (lower case, with its dot: ".npy", ".surf.gii"), in whatever case, and has
/// more to it than that.
inline bool has_ending(const std::filesystem::path& file, std::string_view ending) {
  const std::string name = lower_case(file.filename().string());
  return name.size() > ending.size() && name.ends_with(ending);
}

}  // namespace geodrome
