// SPDX-License-Identifier: MIT
#include "engine/host/plugin_choice.hpp"

#include <algorithm>

#include "engine/host/whole_path.hpp"

namespace geodrome {
namespace {

constexpr std::string_view extension = ".so";

/// Where the name or file ends: at the end, at ".so:", or, in a name, at the first colon.
std::size_t end_of_target(std::string_view text) {
  const std::size_t colon = text.find(".so:");
  if (colon != std::string_view::npos) return colon + extension.size();
  return text.ends_with(extension) ? text.size() : std::min(text.size(), text.find(':'));
}

}  // namespace

PluginChoice parse_choice(std::string_view stage, std::string_view text) {
  const std::size_t end = end_of_target(text);
  std::string_view target = text.substr(0, end);
  PluginChoice choice;
  if (end < text.size()) choice.options = text.substr(end + 1);
  if (target.ends_with(extension) || target.find('/') != std::string_view::npos) {
    choice.file = whole_path(target);
    return choice;
  }
  if (target.size() > stage.size() && target.starts_with(stage) && target[stage.size()] == '_')
    target.remove_prefix(stage.size() + 1);
  choice.name = target;
  return choice;
}

}  // namespace geodrome
