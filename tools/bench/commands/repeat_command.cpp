// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/repeat.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* meaning =
    "A query is one search from a vertex and the copy of all vertex distances. The surface is prepared once; every\n"
    "thread makes one search and uses it again and again. Total: sources over the wall-clock time of all queries,\n"
    "first ones included, and over the number of threads, each of which should have a core of its own. The first\n"
    "query finds buffers that were never touched; the same one is asked again at the end, off the clock: what that\n"
    "saves is what a search used again saves. Figures that every thread has are medians. Wall-clock time: let\n"
    "nothing else run. Build with the release preset.";

struct RepeatArguments {
  std::string mesh, solver = "chen_han";
  std::vector<std::filesystem::path> plugin_path;
  RepeatOptions options;
};

void run(const RepeatArguments& arguments) {
  const auto solver = PluginHost(arguments.plugin_path).load<ShortestPathSolver>(arguments.solver);
  const MeshPtr mesh = load_mesh(arguments.mesh);
  std::cout << arguments.mesh << ": " << mesh->face_count() << " faces, " << mesh->vertex_count() << " vertices\n";
  print(std::cout, solver.info.full_name(), repeat(solver, mesh, arguments.options));
}

}  // namespace

void add_repeat(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<RepeatArguments>();
  CLI::App& command = *app.add_subcommand("repeat", "Sources a second when one search is used again and again.");
  command.footer(meaning);
  command.add_option("mesh", arguments->mesh, "a file, or shape:KIND:FACES[:SEED]")->required();
  command.add_option("--solver", arguments->solver, "NAME[:key=value,...]")->capture_default_str();
  command.add_option("--sources", arguments->options.sources, "random vertices")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--threads", arguments->options.threads, "0: one per core")->capture_default_str();
  command.add_option("--seed", arguments->options.seed, "chooses the sources")->capture_default_str();
  command.add_option("--plugin-path", arguments->plugin_path, "folders searched first");
  command.callback([&action, arguments] { action = [arguments] { run(*arguments); }; });
}

}  // namespace geodrome::bench
