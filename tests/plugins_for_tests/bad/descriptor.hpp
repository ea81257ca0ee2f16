// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/abi.hpp"

/// What plugins of this folder that never come to run are made of.
namespace geodrome::bad {

/// A descriptor without fault, for a plugin to spoil. Its `create` gives no object and no reason.
inline PluginDescriptor descriptor(const char* name) {
  return {sizeof(PluginDescriptor),
          interface_version,
          build_tag,
          "solver",
          name,
          "a bad plugin",
          "MIT",
          Needs::nothing,
          Provides::nothing,
          nullptr,
          0,
          [](const OptionValues*) noexcept { return 1.0; },
          [](const OptionValues*, const ErrorSink*) noexcept -> void* { return nullptr; },
          [](void*) noexcept {},
          nullptr};
}

}  // namespace geodrome::bad

#define GEODROME_BAD_ENTRY(...)                                                                                    \
  extern "C" __attribute__((visibility("default"))) const geodrome::PluginDescriptor* geodrome_plugin() noexcept { \
    static const geodrome::PluginDescriptor bad = __VA_ARGS__;                                                     \
    return &bad;                                                                                                   \
  }
