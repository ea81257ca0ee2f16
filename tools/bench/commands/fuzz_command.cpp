// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/exactness.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* fuzz_meaning =
    "The figures are those of `exactness`. A line for every 100 meshes gives the worst of them, and on how many the "
    "peer\n"
    "was silent (most have vertices with several fans) and proven wrong; these and failures have lines of their own. "
    "To\n"
    "look at one: geodrome-bench exactness fuzz:SEED. Status 1 if there was a failure.";

struct FuzzArguments {
  Rivals rivals;
  std::size_t count = 1000;
  std::uint64_t first_seed = 1;
  bool verbose = false;
  ExactnessOptions options{.sources = 3, .points = 60, .seconds = 60};
};

/// The worst of many meshes.
struct Summary {
  Exactness worst;
  std::size_t meshes = 0, silent = 0, peer_wrong = 0, failures = 0;

  void add(const Exactness& one) {
    const auto raise = [](double& figure, double other) { figure = std::max(figure, other); };
    raise(worst.at_vertices, one.at_vertices), raise(worst.at_points, one.at_points);
    raise(worst.relative, one.relative), raise(worst.paths, one.paths), raise(worst.together, one.together);
    raise(worst.scaled, one.scaled), raise(worst.lipschitz, one.lipschitz);
    raise(worst.audit_paths, one.audit_paths), raise(worst.peer_error, one.peer_error);
    worst.peer_wrong += one.peer_wrong, worst.solver_wrong += one.solver_wrong;
    ++meshes, silent += !one.peer_silent.empty(), peer_wrong += one.peer_wrong > 0, failures += !one.exact();
  }
};

void print_one(std::uint64_t seed, const shapes::FuzzMesh& fuzz, const Exactness& result) {
  std::printf("fuzz:%-10llu %s  %s\n    %s, %zu faces\n%s", static_cast<unsigned long long>(seed),
              exactness_figures(result).c_str(), result.exact() ? "peer wrong" : "NOT EXACT", fuzz.recipe.c_str(),
              fuzz.mesh.face_count(), exactness_notes(result).c_str());
}

void print_summary(std::uint64_t last, const Summary& summary) {
  std::printf("up to %-9llu %s  %zu meshes: peer silent on %zu, wrong on %zu; %zu failures\n",
              static_cast<unsigned long long>(last), exactness_figures(summary.worst).c_str(), summary.meshes,
              summary.silent, summary.peer_wrong, summary.failures);
  std::fflush(stdout);
}

void run(const FuzzArguments& arguments) {
  constexpr std::size_t meshes_a_line = 100;
  const PluginHost host(arguments.rivals.plugin_path);
  const auto solver = host.load<ShortestPathSolver>(arguments.rivals.solver);
  const auto peer = load_peer(host, arguments.rivals.peer);
  std::printf("%-15s %s\n", "seed", exactness_names().c_str());
  std::size_t failures = 0;
  Summary summary;
  for (std::uint64_t seed = arguments.first_seed; seed < arguments.first_seed + arguments.count; ++seed) {
    const shapes::FuzzMesh fuzz = shapes::fuzz_mesh(seed);
    if (arguments.verbose)
      std::fprintf(stderr, "fuzz:%llu %s\n", static_cast<unsigned long long>(seed), fuzz.recipe.c_str());
    ExactnessOptions options = arguments.options;
    options.seed = seed;
    const Exactness result =
        judge(solver, peer ? &*peer : nullptr, std::make_shared<const SurfaceMesh>(fuzz.mesh), options);
    if (!result.exact() || result.peer_wrong > 0) print_one(seed, fuzz, result);
    failures += !result.exact();
    summary.add(result);
    if (summary.meshes < meshes_a_line && seed + 1 < arguments.first_seed + arguments.count) continue;
    print_summary(seed, summary);
    summary = {};
  }
  if (failures) throw NumericalError(std::to_string(failures) + " meshes failed");
}

}  // namespace

void add_fuzz(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<FuzzArguments>(
      app, action, "fuzz", "Whether a solver is exact on random broken meshes.", fuzz_meaning, run);
  command.add_option("--count", arguments.count, "of meshes")->capture_default_str();
  command.add_option("--first-seed", arguments.first_seed, "of the first mesh; the next ones follow")
      ->capture_default_str();
  add_solver(command, arguments.rivals);
  add_peer(command, arguments.rivals, "NAME[:key=value,...], or none");
  command
      .add_option("--share", arguments.options.share,
                  "of the faces that are audited and of the paths that are measured")
      ->check(CLI::Range(1e-3, 1.0))
      ->capture_default_str();
  command.add_option("--seconds", arguments.options.seconds, "a search that takes longer is given up")
      ->capture_default_str();
  command.add_flag("--verbose", arguments.verbose, "tell every mesh before it is judged, to find one that crashes");
}

}  // namespace geodrome::bench
