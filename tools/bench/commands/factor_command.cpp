// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/factor.hpp"
#include "tools/bench/solvers/list.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* factor_meaning =
    "D: the solver's distances, d: those of the exact peer, at all vertices and at points in faces. max, mean: of\n"
    "D/d - 1. above: share of the places with D > factor d + 1e-12 of the largest distance; must be 0. below: largest\n"
    "d - D over the largest distance. Seconds: one thread; median of the sources, one search each; prepare: with the\n"
    "solver's own structures. Counters: medians. Exponents in 1/delta, delta = factor - 1: least squares in log-log;\n"
    "theory of Aleksandrov, Maheshwari and Sack: points on bisectors delta^-1/2 log(1/delta), edges delta^-1\n"
    "log^2(1/delta), so that the logarithms add to the fitted 0.5 and 1. Status 1 if a solver that states a factor\n"
    "breaks it, or is below d by more than 1e-12.";

struct FactorArguments {
  std::vector<std::string> meshes;
  Rivals rivals{.solver = "aleksandrov", .peer = "chen_han", .plugin_path = {}};  ///< of several solvers
  FactorOptions options;
};

void print_result(const std::string& mesh, std::size_t faces, const std::string& solver, const FactorResult& r) {
  const FactorFigures& f = r.figures;
  std::printf("%-28s %8zu %-30s %7.4g %9.2e %9.2e %9.2e %9.2e %9.4f %9.4f %9.4f%s\n", mesh.c_str(), faces,
              solver.c_str(), r.factor, f.largest_excess, f.mean_excess,
              static_cast<double>(f.above) / static_cast<double>(std::max<std::size_t>(1, f.judged)), f.shortfall,
              r.prepare_seconds, r.seconds, r.exact_seconds, r.holds() ? "" : "  BROKEN");
  std::printf("    %zu places", f.places);
  for (const auto& [name, value] : r.counters) std::printf(", %s %.0f", name.c_str(), value);
  std::printf("\n");
  std::fflush(stdout);
}

void print_exponents(const std::string& mesh, const std::string& solver, std::span<const FactorResult> results) {
  const auto exponents = exponents_in_delta(results);
  if (exponents.empty()) return;
  std::printf("%-28s %-30s exponents in 1/delta:", mesh.c_str(), solver.c_str());
  const char* before = " ";
  for (const auto& [name, exponent] : exponents)
    std::printf("%s%s %.2f", std::exchange(before, ", "), name.c_str(), exponent);
  std::printf("\n");
}

/// Returns how many solvers broke their factor on one mesh.
std::size_t run_mesh(const std::string& name, const PluginHost& host, const FactorArguments& arguments) {
  const MeshPtr mesh = load_mesh(name);
  if (mesh->face_count() == 0) throw InputError(InputFault::empty, name + " has no face");
  const auto peer = host.load<ShortestPathSolver>(arguments.rivals.peer);
  if (peer.factor != 1) throw OptionError("the peer " + arguments.rivals.peer + " is not exact");
  const ExactDistances exact = exact_distances(peer, mesh, arguments.options);
  std::map<std::string, std::vector<FactorResult>> families;  // solvers that differ by delta only
  std::size_t broken = 0;
  for (const std::string& solver : split_solvers(arguments.rivals.solver)) {
    const FactorResult result = judge_factor(host.load<ShortestPathSolver>(solver), exact, arguments.options);
    print_result(name, mesh->face_count(), solver, result);
    families[without_option(solver, "delta")].push_back(result);
    broken += !result.holds();
  }
  for (const auto& [solver, results] : families) print_exponents(name, solver, results);
  return broken;
}

void run(const FactorArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  std::printf("peer %s, %zu sources\n", arguments.rivals.peer.c_str(), arguments.options.sources);
  std::printf("%-28s %8s %-30s %7s %9s %9s %9s %9s %9s %9s %9s\n", "mesh", "faces", "solver", "factor", "max", "mean",
              "above", "below", "prepare s", "seconds", "peer s");
  std::size_t broken = 0;
  for (const std::string& mesh : arguments.meshes) broken += run_mesh(mesh, host, arguments);
  if (broken) throw NumericalError(std::to_string(broken) + " times a factor was broken");
}

}  // namespace

void add_factor(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<FactorArguments>(
      app, action, "factor", "Whether solvers keep the factors they state, at what cost.", factor_meaning, run);
  FactorOptions& options = arguments.options;
  add_meshes(command, arguments.meshes);
  add_solver(command, arguments.rivals, "NAME[:key=value,...], several separated by commas");
  add_peer(command, arguments.rivals, "an exact solver");
  add_count(command, "--sources", options.sources,
            "in turn at a vertex and inside a face, where the solver takes these");
  add_judging(command, options);
}

}  // namespace geodrome::bench
