// SPDX-License-Identifier: MIT
#include "geodrome/engine/plugin_text.hpp"

#include "engine/report/json.hpp"

namespace geodrome {

std::string json_text(const PluginInfo& plugin) { return text_of(to_json(plugin)); }

std::string json_text(const std::vector<PluginInfo>& plugins) {
  Json json = Json::array();
  for (const PluginInfo& plugin : plugins) json.push_back(to_json(plugin));
  return text_of(json);
}

std::string json_text(const PluginListing& listing) { return text_of(to_json(listing)); }

}  // namespace geodrome
