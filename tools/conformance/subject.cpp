// SPDX-License-Identifier: MIT
#include <algorithm>

#include "geodrome/conformance.hpp"
#include "geodrome/engine/plugin_host.hpp"

namespace geodrome::conformance {
namespace {

bool is_file(const std::string& name) { return name.find('/') != std::string::npos || name.ends_with(".so"); }

std::string names_of(const std::vector<PluginInfo>& plugins) {
  std::string names;
  for (const PluginInfo& plugin : plugins) names += (names.empty() ? "" : ", ") + plugin.full_name();
  return names.empty() ? "none" : names;
}

PluginInfo find_plugin(const PluginHost& host, const std::string& name) {
  if (is_file(name)) return host.inspect(name);
  const std::vector<PluginInfo> usable = host.list().usable;
  std::vector<PluginInfo> found;
  std::ranges::copy_if(usable, std::back_inserter(found),
                       [&](const PluginInfo& plugin) { return plugin.name == name || plugin.full_name() == name; });
  if (found.size() == 1) return found.front();
  if (found.empty()) throw OptionError("no plugin '" + name + "'", "there are: " + names_of(usable));
  throw OptionError("'" + name + "' may be " + names_of(found), "give the name with its stage");
}

}  // namespace

Subject find_subject(const std::string& selection, const std::vector<std::filesystem::path>& plugin_path) {
  const std::size_t colon = selection.find(':');
  Subject subject;
  subject.plugin = find_plugin(PluginHost(plugin_path), selection.substr(0, colon));
  if (colon != std::string::npos) subject.options = selection.substr(colon + 1);
  subject.plugin_path = plugin_path;
  return subject;
}

}  // namespace geodrome::conformance
