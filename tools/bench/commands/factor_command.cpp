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
    "solver's own structures. Counters: medians.\n"
    "Intervals [l, D], of solvers that state them: l/d - 1 and (l - d) over the largest distance, the largest; places\n"
    "with l > d, with D > factor l, and with |d - D| > D - l; must be 0. Empty runs: l = D everywhere, exact ones.\n"
    "Paths are traced from places and measured on the surface: length/d - 1, the largest and the mean; how many are\n"
    "shorter than d and, where a factor is stated, longer than D; must be 0. All up to 1e-12 of the largest distance.\n"
    "Exponents in 1/delta, delta = factor - 1: least squares in log-log; theory of Aleksandrov, Maheshwari and Sack:\n"
    "points on bisectors delta^-1/2 log(1/delta), edges delta^-1 log^2(1/delta), so that the logarithms add to the\n"
    "fitted 0.5 and 1. Of several meshes the worst comes last. Status 1 if a solver that states a factor breaks it or\n"
    "is below d by more than 1e-12, if an interval or a path is wrong, or if a solver throws.";

struct FactorArguments {
  std::vector<std::string> meshes;
  Rivals rivals{.solver = "aleksandrov", .peer = "chen_han", .plugin_path = {}};  ///< of several solvers
  FactorOptions options;
  bool brief = false;
};

double mean(double sum, std::size_t count) { return sum / static_cast<double>(std::max<std::size_t>(1, count)); }

void print_bounds(const BoundFigures& b) {
  if (b.runs == 0) return;
  std::printf("    intervals: l/d - 1 %.1e, (l - d) %.1e; D/l - 1 %.2e, mean %.2e; %zu l > d, %zu D > factor l, ",
              b.largest_excess, b.largest_over, b.largest_width, mean(b.width_sum, b.widths), b.too_long, b.too_wide);
  std::printf("%zu beside d; empty in %zu of %zu runs\n", b.beside, b.empty_runs, b.runs);
}

void print_paths(const PathFigures& p) {
  if (p.paths == 0) return;
  std::printf(
      "    %zu paths: length/d - 1 %.2e, mean %.2e; %zu shorter than d (by %.1e), %zu longer than D (by %.1e)\n",
      p.paths, p.largest_excess, mean(p.excess_sum, p.ratios), p.too_short, p.largest_short, p.too_long,
      p.largest_detour);
}

void print_distances(const std::string& mesh, std::size_t faces, const std::string& solver, const FactorResult& r) {
  const FactorFigures& f = r.figures;
  std::printf("%-28s %8zu %-30s %7.6g %9.2e %9.2e %9.2e %9.2e", mesh.c_str(), faces, solver.c_str(), r.factor,
              f.largest_excess, f.mean_excess, mean(static_cast<double>(f.above), f.judged), f.shortfall);
}

void print_times(const FactorResult& r) {
  std::printf(" %9.4f %9.4f %9.4f%s\n    %zu places", r.prepare_seconds, r.seconds, r.exact_seconds,
              r.holds() ? "" : "  BROKEN", r.figures.places);
  for (const auto& [name, value] : r.counters) std::printf(", %s %.0f", name.c_str(), value);
  std::printf("\n");
}

void print_rest(const FactorResult& r) {
  print_bounds(r.bounds), print_paths(r.paths);
  for (const std::string& text : {r.where, r.failure})
    if (!text.empty()) std::printf("    %s\n", text.c_str());
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

/// The results of each solver.
using Results = std::map<std::string, std::vector<FactorResult>>;

/// Adds the results of all solvers on one mesh.
void run_mesh(const std::string& name, const PluginHost& host, const FactorArguments& arguments, Results& all) {
  const MeshPtr mesh = load_mesh(name);
  if (mesh->face_count() == 0) throw InputError(InputFault::empty, name + " has no face");
  const auto peer = host.load<ShortestPathSolver>(arguments.rivals.peer);
  if (peer.factor != 1) throw OptionError("the peer " + arguments.rivals.peer + " is not exact");
  const ExactDistances exact = exact_distances(peer, mesh, arguments.options);
  Results families;  // solvers that differ by delta only
  for (const std::string& solver : split_solvers(arguments.rivals.solver)) {
    const FactorResult result = judge_factor(host.load<ShortestPathSolver>(solver), exact, arguments.options);
    if (!arguments.brief || !result.holds())
      print_distances(name, mesh->face_count(), solver, result), print_times(result), print_rest(result);
    families[without_option(solver, "delta")].push_back(result);
    all[solver].push_back(result);
  }
  if (arguments.brief) return;
  for (const auto& [solver, results] : families) print_exponents(name, solver, results);
}

void print_worst(const Results& all, bool brief) {
  for (const auto& [solver, results] : all) {
    if (results.size() == 1 && !brief) continue;
    const FactorResult worst = worst_of(results);
    const std::ptrdiff_t broken = std::ranges::count(results, false, &FactorResult::holds);
    print_distances("worst of all", worst.faces, solver, worst);
    std::printf("\n    %zu meshes, %td broken, %zu searches, %zu places\n", results.size(), broken, worst.searches,
                worst.figures.places);
    print_rest(worst);
  }
}

void run(const FactorArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  std::printf("peer %s, %zu searches\n", arguments.rivals.peer.c_str(), arguments.options.sources);
  std::printf("%-28s %8s %-30s %7s %9s %9s %9s %9s %9s %9s %9s\n", "mesh", "faces", "solver", "factor", "max", "mean",
              "above", "below", "prepare s", "seconds", "peer s");
  Results all;
  for (const std::string& mesh : arguments.meshes) run_mesh(mesh, host, arguments, all);
  print_worst(all, arguments.brief);
  std::ptrdiff_t broken = 0;
  for (const auto& [solver, results] : all) broken += std::ranges::count(results, false, &FactorResult::holds);
  if (broken) throw NumericalError(std::to_string(broken) + " times a promise was broken");
}

}  // namespace

void add_factor(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<FactorArguments>(
      app, action, "factor", "Whether solvers keep the factors they state, at what cost.", factor_meaning, run);
  FactorOptions& options = arguments.options;
  add_meshes(command, arguments.meshes);
  add_solver(command, arguments.rivals, "NAME[:key=value,...], several separated by commas");
  add_peer(command, arguments.rivals, "an exact solver");
  add_count(
      command, "--sources", options.sources,
      "searches: in turn from a vertex, inside a face, on an edge, several at once, where the solver takes these");
  command.add_option("--paths", options.paths, "a search: from so many vertices, and from as many points")
      ->capture_default_str();
  command.add_flag("--brief", arguments.brief, "only what is broken, and the worst of all");
  add_judging(command, options);
}

}  // namespace geodrome::bench
