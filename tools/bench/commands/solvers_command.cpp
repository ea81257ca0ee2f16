// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/race.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* solvers_meaning =
    "Conditions: one thread, both solvers in one process and one run, interleaved, the first one changing every run. "
    "A\n"
    "query is one search from a vertex and the copy of all vertex distances; each solver keeps one search, which has "
    "had one\n"
    "query from that source before the clock starts. Preparing the surface is timed apart (median of 3). Figures are "
    "medians\n"
    "over the runs of a source, then over the sources. A run in which the peer took over 1.2 times its own median is "
    "void.\n"
    "Windows: the solver's counter windows_propagated of a source; time a window is that of the whole query. -: not "
    "counted.\n"
    "Processor time of the thread. What else runs still uses the caches: compare within one run. Build with the\n"
    "release preset.";

struct SolversArguments {
  std::string mesh;
  Rivals rivals;
  RaceOptions options;
};

void run(const SolversArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  const auto solver = host.load<ShortestPathSolver>(arguments.rivals.solver);
  const auto peer = host.load<ShortestPathSolver>(arguments.rivals.peer);
  const MeshPtr mesh = load_mesh(arguments.mesh);
  std::cout << arguments.mesh << ": " << mesh->face_count() << " faces, " << mesh->vertex_count() << " vertices; "
            << arguments.options.sources << " sources, " << arguments.options.runs << " runs\n";
  print(std::cout, race(solver, peer, mesh, arguments.options));
}

}  // namespace

void add_solvers(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<SolversArguments>(
      app, action, "solvers", "A solver against a peer on one mesh: ratios of medians.", solvers_meaning, run);
  add_mesh(command, arguments.mesh);
  add_solver(command, arguments.rivals);
  add_peer(command, arguments.rivals);
  add_count(command, "--sources", arguments.options.sources, "random vertices");
  add_count(command, "--runs", arguments.options.runs, "runs per source");
  command.add_option("--seed", arguments.options.seed, "chooses the sources")->capture_default_str();
}

}  // namespace geodrome::bench
