// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/abi.hpp"
#include "geodrome/engine/plugin_info.hpp"

namespace geodrome {

/// Copies a descriptor that passed the handshake and checks that it makes sense: a known stage, a usable name, no null
/// strings, options with names of their own whose defaults pass their own check, no unknown bits, no answer to an
/// extension that does not exist, a factor of at least 1. Throws PluginError with what is wrong.
PluginInfo checked_info(const PluginDescriptor& plugin);

}  // namespace geodrome
