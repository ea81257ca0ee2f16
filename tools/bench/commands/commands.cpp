// SPDX-License-Identifier: MIT
#include "tools/bench/commands/commands.hpp"

namespace geodrome::bench {

namespace {

void add_plugin_path(CLI::App& command, std::vector<std::filesystem::path>& folders) {
  command.add_option("--plugin-path", folders, "folder searched first (may be repeated)")->allow_extra_args(false);
}

constexpr const char* kinds_of_mesh =
    "a file, shape:KIND:FACES[:SEED], hostile:NAME:SIZE[:SEED] (SIZE 0 to 2) or fuzz:SEED";

}  // namespace

void add_mesh(CLI::App& command, std::string& mesh) { command.add_option("mesh", mesh, kinds_of_mesh)->required(); }

void add_meshes(CLI::App& command, std::vector<std::string>& meshes) {
  command.add_option("meshes", meshes, std::string("each ") + kinds_of_mesh)->required();
}

void add_solver(CLI::App& command, Rivals& rivals, const char* help) {
  command.add_option("--solver", rivals.solver, help)->capture_default_str();
  add_plugin_path(command, rivals.plugin_path);
}

void add_peer(CLI::App& command, Rivals& rivals, const char* help) {
  command.add_option("--peer", rivals.peer, help)->capture_default_str();
}

void add_truth(CLI::App& command, TruthChoice& choice) {
  command.add_option("--truth", choice.solver, "the exact solver on a mesh of the true surface")->capture_default_str();
  add_count(command, "--truth-faces", choice.faces, "of that mesh, about");
  add_count(command, "--targets", choice.targets,
            "random points of each sample that distances of a source are judged at");
}

CLI::Option* add_count(CLI::App& command, const char* flag, std::size_t& count, const char* help) {
  return command.add_option(flag, count, help)->capture_default_str()->check(CLI::PositiveNumber);
}

void add_stages(CLI::App& command, RunSettings& settings) {
  const auto add = [&](const char* flag, std::string& choice, const char* help) {
    command.add_option(flag, choice, help)->type_name("NAME[:k=v,...]")->capture_default_str();
  };
  add("--tangent", settings.stages.tangent, "tangent planes");
  add("--control", settings.stages.control, "control function psi");
  add("--decimator", settings.stages.decimator, "decimation of the sample");
  add("--reconstructor", settings.stages.reconstructor, "surface through the kept points");
  add_plugin_path(command, settings.plugin_path);
}

void add_threads(CLI::App& command, RunSettings& settings) {
  settings.threads = 1;
  command.add_option("--threads", settings.threads, "of every stage; 0: one per core")->capture_default_str();
}

}  // namespace geodrome::bench
