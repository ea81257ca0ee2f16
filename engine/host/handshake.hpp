// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <optional>
#include <string>

#include "geodrome/abi.hpp"

namespace geodrome {

/// The interface versions whose plugins a host takes.
struct AcceptedVersions {
  std::uint32_t oldest = oldest_interface_version, newest = interface_version;

  bool hold(std::uint32_t version) const { return oldest <= version && version <= newest; }
  std::string text() const {
    if (oldest == newest) return "version " + std::to_string(newest);
    return "versions " + std::to_string(oldest) + " to " + std::to_string(newest);
  }
};

/// Tells whether a descriptor of `size` bytes has all members that every accepted version has, and ends behind one.
inline bool is_descriptor_size(std::uint32_t size) {
  return smallest_descriptor <= size && size <= sizeof(PluginDescriptor) && size % alignof(PluginDescriptor) == 0;
}

/// Returns why this host must not use a plugin, or nothing. Reads only the first three members of the descriptor, since
/// the rest may lie elsewhere in a plugin of a version that is not accepted.
inline std::optional<std::string> handshake_fault(const PluginDescriptor* plugin, AcceptedVersions accepted = {}) {
  if (plugin == nullptr) return std::string(plugin_entry) + " returned no descriptor";
  if (!accepted.hold(plugin->interface_version))
    return "built for interface version " + std::to_string(plugin->interface_version) + ", this host takes " +
           accepted.text() + "; rebuild the plugin against this Geodrome";
  if (!is_descriptor_size(plugin->size))
    return "its descriptor has " + std::to_string(plugin->size) + " bytes, this host's has " +
           std::to_string(sizeof(PluginDescriptor)) + "; rebuild the plugin against this Geodrome";
  if (plugin->build_tag == nullptr) return "its descriptor has no build tag";
  if (std::strcmp(plugin->build_tag, build_tag) != 0)
    return "built as '" + std::string(plugin->build_tag) + "', this host is built as '" + build_tag +
           "'; rebuild the plugin the same way";
  return std::nullopt;
}

/// Copies a descriptor that passed the handshake. Members beyond its size, which an older plugin does not have, are
/// null in the copy; nothing beyond its size is read.
inline PluginDescriptor whole_descriptor(const PluginDescriptor& plugin) {
  PluginDescriptor whole{};
  std::memcpy(&whole, &plugin, plugin.size);
  return whole;
}

}  // namespace geodrome
