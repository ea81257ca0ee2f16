// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <sstream>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/pairs.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* meaning =
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
  std::string solvers = "aleksandrov", peer = "chen_han";
  std::vector<std::filesystem::path> plugin_path;
  PairOptions options;
};

/// "A,B:k=v,l=w,C": a comma followed by key=value belongs to the options of the solver before.
std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) {
    const bool is_option = word.find('=') != std::string::npos && word.find(':') == std::string::npos;
    if (is_option && !names.empty())
      names.back() += "," + word;
    else
      names.push_back(word);
  }
  return names;
}

/// Rows of one mesh; the number of unsound ones.
std::size_t run_mesh(const std::string& name, const PluginHost& host, const QueriesArguments& arguments) {
  const PairOptions& options = arguments.options;
  const MeshPtr mesh = load_mesh(name);
  const PairSet pairs = choose_pairs(*mesh, options);
  const PairTruth truth = truth_of(host.load<ShortestPathSolver>(arguments.peer), mesh, pairs, options);
  std::size_t failures = 0;
  for (const std::string& solver : split(arguments.solvers)) {
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
  const PluginHost host(arguments.plugin_path);
  std::printf("peer %s; %zu pairs, %zu sources\n%-28s %8s %-28s %s\n", arguments.peer.c_str(), arguments.options.pairs,
              arguments.options.sources, "mesh", "faces", "solver", pair_names().c_str());
  std::size_t failures = 0;
  for (const std::string& name : arguments.meshes) failures += run_mesh(name, host, arguments);
  if (failures) throw NumericalError(std::to_string(failures) + " rows have wrong distances");
}

}  // namespace

void add_queries(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<QueriesArguments>();
  CLI::App& command = *app.add_subcommand("queries", "What a pair oracle costs, how accurate it is, when it pays.");
  command.footer(meaning);
  PairOptions& options = arguments->options;
  command
      .add_option("meshes", arguments->meshes, "files, shape:KIND:FACES[:SEED], hostile:NAME:SIZE[:SEED] or fuzz:SEED")
      ->required();
  command.add_option("--solver", arguments->solvers, "NAME[:key=value,...][,NAME...]: with pair_queries")
      ->capture_default_str();
  command.add_option("--peer", arguments->peer, "an exact solver, NAME[:key=value,...]")->capture_default_str();
  command.add_option("--pairs", options.pairs, "random pairs")->capture_default_str()->check(CLI::PositiveNumber);
  command.add_option("--sources", options.sources, "different ones among the pairs")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--searches", options.searches, "timed, of each of the two solvers")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--threads", options.threads, "of preparing and building")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--seed", options.seed, "chooses the pairs")->capture_default_str();
  command.add_option("--plugin-path", arguments->plugin_path, "folder searched first (may be repeated)")
      ->allow_extra_args(false);
  command.callback([&action, arguments] { action = [arguments] { run(*arguments); }; });
}

}  // namespace geodrome::bench
