// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geodrome {

/// "name[:key=value,...]" taken apart. Either `name` or `file` is set.
struct PluginChoice {
  std::string name;            ///< without its stage
  std::filesystem::path file;  ///< absolute
  std::string options;
};

/// Parses a choice: text with a '/', or that ends in ".so", is a file; all else is a name, which may carry its stage
/// ("solver_cgal").
PluginChoice parse_choice(std::string_view stage, std::string_view text);

}  // namespace geodrome
