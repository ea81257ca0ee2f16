// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "geodrome/capabilities.hpp"
#include "geodrome/options.hpp"

namespace geodrome {

/// An OptionSpec with strings of its own.
struct OptionInfo {
  std::string name;
  OptionType type = OptionType::boolean;
  std::string default_value;
  double minimum = 0, maximum = 0;
  std::string choices, unit, help;
};

/// The description that a plugin gives of itself, copied out of its descriptor.
struct PluginInfo {
  std::filesystem::path file;
  std::string stage, name, summary, licence;
  Needs needs = Needs::nothing;
  Provides provides = Provides::nothing;
  double default_factor = 0;  ///< with default options; +inf for none
  std::vector<OptionInfo> options;

  /// "solver_cgal": how messages and reports name it.
  std::string full_name() const { return stage + "_" + name; }
};

/// A file that looked like a plugin and is none that can be used.
struct PluginRefusal {
  std::filesystem::path file;
  std::string reason;
};

}  // namespace geodrome
