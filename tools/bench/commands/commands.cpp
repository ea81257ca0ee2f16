// SPDX-License-Identifier: MIT
#include "tools/bench/commands/commands.hpp"

namespace geodrome::bench {

void add_stages(CLI::App& command, RunSettings& settings) {
  const auto add = [&](const char* flag, std::string& choice, const char* help) {
    command.add_option(flag, choice, help)->type_name("NAME[:k=v,...]")->capture_default_str();
  };
  add("--tangent", settings.stages.tangent, "tangent planes");
  add("--control", settings.stages.control, "control function psi");
  add("--decimator", settings.stages.decimator, "decimation of the sample");
  add("--reconstructor", settings.stages.reconstructor, "surface through the kept points");
  command.add_option("--plugin-path", settings.plugin_path, "folder searched first (may be repeated)")
      ->allow_extra_args(false);
}

void add_threads(CLI::App& command, RunSettings& settings) {
  settings.threads = 1;
  command.add_option("--threads", settings.threads, "of every stage; 0: one per core")->capture_default_str();
}

}  // namespace geodrome::bench
