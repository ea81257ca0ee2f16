// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "geodrome/engine/plugin_host.hpp"

/// Turns the descriptions that plugins give of themselves into JSON. All functions are pure and take time linear in
/// their result.
namespace geodrome {

/// A plugin as a JSON object: stage, name, summary, licence, file, options; of solvers also factor, needs and provides.
/// Here and below: indented by two spaces, no newline at the end, numbers that are not finite as "inf" and "-inf", and
/// U+FFFD for what is no UTF-8 in a file's name.
std::string json_text(const PluginInfo& plugin);

/// An array of such objects.
std::string json_text(const std::vector<PluginInfo>& plugins);

/// An object of two arrays: `usable` of such objects, `refused` of objects with file and reason.
std::string json_text(const PluginListing& listing);

}  // namespace geodrome
