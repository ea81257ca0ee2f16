// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/repeat.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* repeat_meaning =
    "A query is one search from a vertex and the copy of all vertex distances. The surface is prepared once; every\n"
    "thread makes one search and uses it again and again. Total: sources over the wall-clock time of all queries,\n"
    "first ones included, and over the number of threads, each of which should have a core of its own. The first\n"
    "query finds buffers that were never touched; the same one is asked again at the end, off the clock: what that\n"
    "saves is what a search used again saves. Figures that every thread has are medians. Wall-clock time: let\n"
    "nothing else run. Build with the release preset.";

struct RepeatArguments {
  std::string mesh;
  Rivals rivals;
  RepeatOptions options;
};

void run(const RepeatArguments& arguments) {
  const auto solver = PluginHost(arguments.rivals.plugin_path).load<ShortestPathSolver>(arguments.rivals.solver);
  const MeshPtr mesh = load_mesh(arguments.mesh);
  std::cout << arguments.mesh << ": " << mesh->face_count() << " faces, " << mesh->vertex_count() << " vertices\n";
  print(std::cout, solver.info.full_name(), repeat(solver, mesh, arguments.options));
}

}  // namespace

void add_repeat(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<RepeatArguments>(
      app, action, "repeat", "Sources a second when one search is used again and again.", repeat_meaning, run);
  add_mesh(command, arguments.mesh);
  add_solver(command, arguments.rivals);
  add_count(command, "--sources", arguments.options.sources, "random vertices");
  command.add_option("--threads", arguments.options.threads, "0: one per core")->capture_default_str();
  command.add_option("--seed", arguments.options.seed, "chooses the sources")->capture_default_str();
}

}  // namespace geodrome::bench
