// SPDX-License-Identifier: MIT
// What the host takes for an answer of `geodrome-vet`.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/host/plugin_json.hpp"
#include "engine/host/vetting.hpp"
#include "geodrome/abi.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

using nlohmann::json;

json answer() {
  return {{"interface_version", interface_version},
          {"build_tag", build_tag},
          {"plugin",
           {{"stage", "solver"},
            {"name", "own"},
            {"summary", "s"},
            {"licence", "MIT"},
            {"needs", 1},
            {"provides", 2},
            {"default_factor", "inf"},
            {"options", json::array()}}}};
}

PluginInfo read(const json& text) {
  return std::get<PluginInfo>(read_answer("p.so", {.exited = true, .out = text.dump()}));
}

TEST(VetAnswer, TellsWhatThePluginIs) {
  const PluginInfo plugin = read(answer());
  EXPECT_EQ(plugin.full_name(), "solver_own");
  EXPECT_EQ(plugin.needs, Needs::manifold);
  EXPECT_EQ(plugin.default_factor, infinity);
}

TEST(VetAnswer, IsNoneWhereANumberIsNone) {
  for (const json& value : {json(1e300), json(-1), json(0.5), json("1"), json()}) {
    json bad = answer();
    bad["plugin"]["needs"] = value;
    EXPECT_THROW(read(bad), json::exception) << value;
    bad = answer();
    bad["interface_version"] = value;
    EXPECT_THROW(read(bad), json::exception) << value;
  }
  json bad = answer();
  bad["plugin"]["default_factor"] = "many";
  EXPECT_THROW(read(bad), json::exception);
}

TEST(VetAnswer, IsNoneWhereTheTypeOfAnOptionIsNone) {
  json good = answer();
  good["plugin"]["options"].push_back({{"name", "rule"},
                                       {"type", 3},
                                       {"default", "fast"},
                                       {"minimum", 0},
                                       {"maximum", 0},
                                       {"choices", "fast|exact"},
                                       {"unit", ""},
                                       {"help", "h"}});
  EXPECT_EQ(read(good).options.at(0).type, OptionType::choice);
  for (const json& type : {json(4), json(1ULL << 32U), json(-1), json("choice")}) {
    json bad = good;
    bad["plugin"]["options"][0]["type"] = type;
    EXPECT_THROW(read(bad), json::exception) << type;
  }
}

TEST(VetAnswer, OfAnotherVersionIsRefusedNamingBoth) {
  json other = answer();
  other["interface_version"] = 7;
  try {
    read(other);
    FAIL();
  } catch (const PluginError& error) {
    EXPECT_NE(error.message().find("for interface version 7"), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace geodrome
