// SPDX-License-Identifier: MIT
#include "geodrome/conformance.hpp"
#include "geodrome/engine/plugin_host.hpp"

namespace geodrome::conformance {
namespace {

PluginInfo only_one(const std::vector<PluginInfo>& found, const std::string& name) {
  if (found.size() == 1) return found.front();
  std::string names;
  for (const PluginInfo& plugin : found) names += (names.empty() ? "" : ", ") + plugin.full_name();
  throw OptionError("'" + name + "' may be " + names, "give the name with its stage");
}

}  // namespace

Subject find_subject(const std::string& selection, const std::vector<std::filesystem::path>& plugin_path) {
  const std::size_t colon = selection.find(':');
  const std::string name = selection.substr(0, colon);
  const PluginHost host(plugin_path);
  Subject subject;
  // What ends in ".so" is a file, as in a selection.
  subject.plugin = name.ends_with(".so") ? host.inspect(name) : only_one(host.named(name), name);
  if (colon != std::string::npos) subject.options = selection.substr(colon + 1);
  subject.plugin_path = plugin_path;
  return subject;
}

}  // namespace geodrome::conformance
