// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/list.hpp"
#include "tools/bench/solvers/pairs.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* queries_meaning =
    "Pairs: random, by source; vertices and points inside faces by turns. build: the oracle, after prepare. index: "
    "what\n"
    "it saves. us/query: one pair on one thread, median over the sources. errors: D/d - 1 against the peer, over "
    "pairs\n"
    "that both reach. above: pairs above the solver's factor where it is promised, below: pairs below the peer, by "
    "more\n"
    "than 1e-12 of the largest distance; reach: reached by one alone; all three must be 0, else status 1. search, "
    "peer:\n"
    "one search from one source to one target, stopped there where the solver can, by the solver without its oracle "
    "and\n"
    "by the peer (medians over sources). pays above: so many pairs, all of different sources, after which building "
    "has\n"
    "paid against the searches before it; -: never. Wall-clock time: let nothing else run. Build with the release\n"
    "preset.";

struct QueriesArguments {
  std::vector<std::string> meshes;
  Rivals rivals{.solver = "aleksandrov", .peer = "chen_han", .plugin_path = {}};  ///< of several solvers
  PairOptions options;
};

/// Rows of one mesh; the number of unsound ones.
std::size_t run_mesh(const std::string& name, const PluginHost& host, const QueriesArguments& arguments) {
  const PairOptions& options = arguments.options;
  const MeshPtr mesh = load_mesh(name);
  const PairSet pairs = choose_pairs(*mesh, options);
  const PairTruth truth = truth_of(host.load<ShortestPathSolver>(arguments.rivals.peer), mesh, pairs, options);
  std::size_t failures = 0;
  for (const std::string& solver : split_solvers(arguments.rivals.solver)) {
    const auto plugin = host.load<ShortestPathSolver>(solver);
    const PairFigures figures = pair_figures(plugin, mesh, pairs, truth, options);
    std::printf("%-28s %8zu %-28s %s%s\n", name.c_str(), mesh->face_count(), solver.c_str(),
                pair_row(figures, truth).c_str(), figures.sound() ? "" : "  WRONG");
    std::fflush(stdout);
    failures += !figures.sound();
  }
  return failures;
}

void run(const QueriesArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  std::printf("peer %s; %zu pairs, %zu sources\n%-28s %8s %-28s %s\n", arguments.rivals.peer.c_str(),
              arguments.options.pairs, arguments.options.sources, "mesh", "faces", "solver", pair_names().c_str());
  std::size_t failures = 0;
  for (const std::string& name : arguments.meshes) failures += run_mesh(name, host, arguments);
  if (failures) throw NumericalError(std::to_string(failures) + " rows have wrong distances");
}

}  // namespace

void add_queries(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<QueriesArguments>(
      app, action, "queries", "What a pair oracle costs, how accurate it is, when it pays.", queries_meaning, run);
  PairOptions& options = arguments.options;
  add_meshes(command, arguments.meshes);
  add_solver(command, arguments.rivals, "NAME[:key=value,...][,NAME...]: with pair_queries");
  add_peer(command, arguments.rivals, "an exact solver, NAME[:key=value,...]");
  add_count(command, "--pairs", options.pairs, "random pairs");
  add_count(command, "--sources", options.sources, "different ones among the pairs");
  add_count(command, "--searches", options.searches, "timed, of each of the two solvers");
  command.add_option("--threads", options.threads, "of preparing and building")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--seed", options.seed, "chooses the pairs")->capture_default_str();
}

}  // namespace geodrome::bench
