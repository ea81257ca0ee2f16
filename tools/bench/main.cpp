// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <iostream>
#include <string>
#include <vector>

#include "geodrome/engine/boundary.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "tools/bench/bench_mesh.hpp"
#include "tools/bench/solver_race.hpp"

namespace {

using namespace geodrome;

constexpr const char* conditions =
    "Conditions: one thread, both solvers in one process and one run, interleaved, the first one changing every run. "
    "A\n"
    "query is one search from a vertex and the copy of all vertex distances; each solver keeps one search, which has "
    "had one\n"
    "query from that source before the clock starts. Preparing the surface is timed apart (median of 3). Figures are "
    "medians\n"
    "over the runs of a source, then over the sources. A run in which the peer took over 1.2 times its own median is "
    "void.\n"
    "Wall-clock time: let nothing else run. Build with the release preset.";

struct Command {
  std::string mesh, solver = "edge_dijkstra", peer = "cgal";
  std::vector<std::filesystem::path> plugin_path;
  bench::RaceOptions options;
};

void run(const Command& command) {
  const PluginHost host(command.plugin_path);
  const auto solver = host.load<ShortestPathSolver>(command.solver), peer = host.load<ShortestPathSolver>(command.peer);
  const MeshPtr mesh = bench::load_mesh(command.mesh);
  std::cout << command.mesh << ": " << mesh->face_count() << " faces, " << mesh->vertex_count() << " vertices; "
            << command.options.sources << " sources, " << command.options.runs << " runs\n";
  bench::print(std::cout, bench::race(solver, peer, mesh, command.options));
}

}  // namespace

int main(int argc, char** argv) {
  install_crash_handlers();
  CLI::App app("Measures Geodrome's plugins against each other.", "geodrome-bench");
  app.require_subcommand(1);
  Command command;
  CLI::App* solvers = app.add_subcommand("solvers", "A solver against a peer on one mesh: ratios of medians.");
  solvers->footer(conditions);
  solvers->add_option("mesh", command.mesh, "a file, or shape:KIND:FACES[:SEED]")->required();
  solvers->add_option("--solver", command.solver, "NAME[:key=value,...]")->capture_default_str();
  solvers->add_option("--peer", command.peer, "NAME[:key=value,...]")->capture_default_str();
  solvers->add_option("--sources", command.options.sources, "random vertices")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  solvers->add_option("--runs", command.options.runs, "runs per source")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  solvers->add_option("--seed", command.options.seed, "chooses the sources")->capture_default_str();
  solvers->add_option("--plugin-path", command.plugin_path, "folders searched first");
  CLI11_PARSE(app, argc, argv);
  try {
    run(command);
  } catch (const std::exception& error) {
    std::cerr << "geodrome-bench: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
