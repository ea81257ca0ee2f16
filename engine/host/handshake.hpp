// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <optional>
#include <string>

#include "geodrome/abi.hpp"

namespace geodrome {

/// Why this host must not use a plugin, or nothing. Reads only the first three members of the descriptor until they
/// agree, since the rest may lie elsewhere in a plugin of another version.
inline std::optional<std::string> handshake_fault(const PluginDescriptor* plugin) {
  if (plugin == nullptr) return std::string(plugin_entry) + " returned no descriptor";
  if (plugin->interface_version != interface_version)
    return "built for interface version " + std::to_string(plugin->interface_version) + ", this host has version " +
           std::to_string(interface_version) + "; rebuild the plugin against this Geodrome";
  if (plugin->size != sizeof(PluginDescriptor))
    return "its descriptor has " + std::to_string(plugin->size) + " bytes, this host's has " +
           std::to_string(sizeof(PluginDescriptor)) + "; rebuild the plugin against this Geodrome";
  if (plugin->build_tag == nullptr) return "its descriptor has no build tag";
  if (std::strcmp(plugin->build_tag, build_tag) != 0)
    return "built as '" + std::string(plugin->build_tag) + "', this host is built as '" + build_tag +
           "'; rebuild the plugin the same way";
  return std::nullopt;
}

}  // namespace geodrome
