// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace geodrome {

/// A path from the root, links seen through. A name that the system cannot look up (too long, links in a circle) stays
/// as it is, since who opens it tells why.
inline std::filesystem::path whole_path(const std::filesystem::path& path) {
  const std::filesystem::path absolute = std::filesystem::absolute(path);
  std::error_code error;
  std::filesystem::path known = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute : known;
}

}  // namespace geodrome
