// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/plugin_host.hpp"

/// The form of the engine's values in reports. Numbers that are not finite become the strings "inf" and "nan", since
/// JSON has none. Members keep the order in which they are written here.
namespace geodrome {

using Json = nlohmann::ordered_json;

Json to_json(double value);
Json to_json(const Finding& finding);
Json to_json(const std::vector<Finding>& findings);
Json to_json(const Input& input);
Json to_json(const PluginInfo& plugin);
Json to_json(const PluginListing& listing);
Json to_json(const StageRecord& record);

/// A report as text. Names of files may hold any bytes, JSON only UTF-8: what is none becomes U+FFFD.
inline std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }

}  // namespace geodrome
