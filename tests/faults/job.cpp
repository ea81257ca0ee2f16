// SPDX-License-Identifier: MIT
#include "tests/faults/job.hpp"

#include <nlohmann/json.hpp>

namespace geodrome::faults {

namespace {

using Json = nlohmann::json;

/// A run that goes on audits the rows that it computes itself, and prepares nothing if none is missing.
bool differs_between_runs(const std::string& key) {
  for (const char* word :
       {"second", "timings", "peak", "cost", "counters", "resumed_rows", "audit", "oracle", "many_searches"})
    if (key.find(word) != std::string::npos) return true;
  return false;
}

void drop_what_differs(Json& json) {
  if (json.is_array())
    for (Json& item : json) drop_what_differs(item);
  if (!json.is_object()) return;
  for (auto item = json.begin(); item != json.end();)
    if (differs_between_runs(item.key()))
      item = json.erase(item);
    else
      drop_what_differs(*item++);
}

}  // namespace

std::string comparable(const std::string& file, const std::string& bytes) {
  if (!file.ends_with(".json")) return bytes;
  Json json = Json::parse(bytes);
  drop_what_differs(json);
  return json.dump() + (bytes.ends_with('\n') ? "\n" : "");
}

}  // namespace geodrome::faults
