// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstring>

#include "engine/host/child.hpp"
#include "engine/host/installed.hpp"
#include "tools/conformance/demand_table.hpp"
#include "tools/conformance/verdict_json.hpp"

namespace geodrome::conformance {
namespace {

std::vector<std::string> arguments(const Subject& subject, const std::string& demand, const Limits& limits) {
  std::string selection = subject.plugin.file.string();
  if (!subject.options.empty()) selection += ":" + subject.options;
  std::vector<std::string> words{selection, demand, std::to_string(limits.megabytes)};
  for (const auto& folder : subject.plugin_path) words.insert(words.end(), {"--plugin-path", folder.string()});
  for (const auto& mesh : subject.meshes) words.insert(words.end(), {"--mesh", mesh.string()});
  return words;
}

/// What is told of a process that gave no verdict.
std::string bad_end(const ChildEnd& end, const Limits& limits) {
  if (end.timed_out) return text("still running after ", limits.seconds, " s");
  if (!end.exited) return "crashed with " + signal_name(end) + last_words(end);
  return text("ended the process with status ", end.status) + last_words(end);
}

}  // namespace

Verdict judge_in_child(const Subject& subject, const std::string& name, const Limits& limits) {
  const JudgedDemand demand = find_demand(subject.plugin.stage, name);
  Verdict verdict{{demand.name, demand.sentence}};
  const auto start = std::chrono::steady_clock::now();
  const std::chrono::milliseconds limit(static_cast<std::int64_t>(1000 * limits.seconds) + 1);
  const ChildEnd end = run_child(installed_program("geodrome-judge"), arguments(subject, name, limits), limit);
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  try {
    if (end.exited && end.status == 0) return verdict_from_json(nlohmann::json::parse(end.out));
  } catch (const nlohmann::json::exception&) {  // the plugin ended the process before there was a verdict
  }
  verdict.failures = 1;
  verdict.expected = "a verdict";
  verdict.found = bad_end(end, limits);
  return verdict;
}

}  // namespace geodrome::conformance
