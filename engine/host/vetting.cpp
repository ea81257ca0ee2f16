// SPDX-License-Identifier: MIT
#include "engine/host/vetting.hpp"

#include <cstdlib>
#include <cstring>

#include "engine/formats/number_text.hpp"
#include "engine/formats/parse_number.hpp"
#include "engine/host/installed.hpp"
#include "engine/host/plugin_json.hpp"
#include "geodrome/abi.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

namespace fs = std::filesystem;

constexpr double default_limit_seconds = 10;
constexpr double longest_limit_seconds = 3600;

double limit_in_seconds() {
  const char* text = std::getenv("GEODROME_VET_TIMEOUT");
  if (text == nullptr) return default_limit_seconds;
  const auto [seconds, fault] = input::parse_number(text);
  if (fault != input::NumberFault::none || !(seconds > 0 && seconds <= longest_limit_seconds))
    throw OptionError("GEODROME_VET_TIMEOUT: '" + std::string(text) +
                      "' is not a number of seconds above 0, up to 3600");
  return seconds;
}

}  // namespace

std::variant<PluginInfo, PluginRefusal> read_answer(const fs::path& file, const ChildEnd& end) {
  const nlohmann::json answer = nlohmann::json::parse(end.out);
  const std::uint64_t version = whole_from_json(answer.at("interface_version"));
  const std::string tag = answer.at("build_tag").get<std::string>();
  if (version != interface_version || tag != build_tag)
    throw PluginError("geodrome-vet beside the engine was built for interface version " + std::to_string(version) +
                          " as \"" + tag + "\", the engine for version " + std::to_string(interface_version) +
                          " as \"" + build_tag + '"',
                      "install both from the same build");
  if (end.status != 0) return PluginRefusal{file, answer.at("refused").get<std::string>()};
  PluginInfo info = answer.at("plugin").get<PluginInfo>();
  info.file = file;
  return info;
}

std::variant<PluginInfo, PluginRefusal> vet(const fs::path& file) {
  const double seconds = limit_in_seconds();
  const std::chrono::milliseconds limit(static_cast<std::int64_t>(1000 * seconds) + 1);
  const ChildEnd end = run_child(installed_program("geodrome-vet"), {file.string()}, limit);
  if (end.timed_out)
    return PluginRefusal{file, "did not finish loading within " + number_text(seconds) + " s" + last_words(end)};
  if (!end.exited) {
    return PluginRefusal{file, "crashed with " + signal_name(end) + " while being loaded" + last_words(end)};
  }
  try {
    return read_answer(file, end);
  } catch (const nlohmann::json::exception&) {
    return PluginRefusal{
        file, "ended the process with status " + std::to_string(end.status) + " while being loaded" + last_words(end)};
  }
}

}  // namespace geodrome
