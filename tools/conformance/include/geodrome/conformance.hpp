// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "geodrome/engine/plugin_info.hpp"

/// What the contract of a stage demands of its plugins, one demand at a time, and verdicts on a plugin.
namespace geodrome::conformance {

/// A plugin to be judged, and what is at hand to judge it by.
struct Subject {
  PluginInfo plugin;                               ///< its file is loaded
  std::string options;                             ///< "key=value,...", as after the colon of a selection
  std::vector<std::filesystem::path> plugin_path;  ///< where the solvers it is compared with are searched for first
  std::vector<std::filesystem::path> meshes;       ///< further meshes that a solver is judged on
};

/// `selection` is "NAME[:key=value,...]" or "FILE[:key=value,...]"; a name may carry its stage and must otherwise be
/// the name of one plugin only. The plugin is vetted in a child process. Throws OptionError for an unknown or ambiguous
/// name, PluginError for a plugin that is refused.
Subject find_subject(const std::string& selection, const std::vector<std::filesystem::path>& plugin_path = {});

/// One demand: a name like "requests.radius", and in a sentence what must hold.
struct Demand {
  std::string name, sentence;
};

/// The demands of a stage, in the order in which they are judged. Names are unique within a stage. Which of them apply
/// to a plugin follows from what it states: provides, needs, factor.
std::vector<Demand> demands(const std::string& stage);

enum class Outcome {
  held,
  failed,
  not_applicable  ///< the plugin does not claim it, or what is needed to judge it is not there: `found` says which
};

/// How a demand came out. `expected`, `found` and `where` tell of the first failure of `failures`.
struct Verdict {
  Demand demand;
  Outcome outcome = Outcome::failed;
  std::string expected, found, where;
  std::size_t checks = 0, failures = 0;
  double seconds = 0;
};

/// Judges in this process: a debugger sees all, but a plugin that crashes or hangs takes the process along. Throws
/// OptionError for an unknown demand. Not to be called from two threads at once.
Verdict judge(const Subject& subject, const std::string& demand);

/// What one demand may take. Most take well below a second; memory is address space.
struct Limits {
  double seconds = 120;
  std::size_t megabytes = 4096;
};

/// Judges in a child process under limits: a crash, a hang, or memory without end is a failed demand that tells so.
/// Throws PluginError if the program geodrome-judge is missing. Thread-safe.
Verdict judge_in_child(const Subject& subject, const std::string& demand, const Limits& limits = {});

/// Verdicts as a JSON object: the plugin (as `geodrome::json_text`), its options, how many demands held, failed and did
/// not apply, and each verdict: of one that failed also where, expected, found, checks and failures.
std::string json_text(const Subject& subject, const std::vector<Verdict>& verdicts);

}  // namespace geodrome::conformance
