// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/bench/shapes/torus_runs.hpp"
#include "tools/bench/solvers/fit.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* accuracy_meaning =
    "Torus R = 1, r = 0.4, uniform samples. epsilon: the largest distance of 100,000 random surface points from the "
    "sample,\n"
    "over the local feature size, 0.4 everywhere: the core circle is that far from every point, the axis at least "
    "0.6.\n"
    "Errors are relative to the true geodesic distance (shooting with 16,384 rays). far: pairs at least a quarter of "
    "the\n"
    "largest distance apart; near: less than a twentieth. mean: of |error|; over, under: of the pairs that are too "
    "long, too\n"
    "short. Exponents: least squares in log-log over all runs of a variant.";

struct AccuracyArguments {
  std::vector<std::size_t> points{2000, 4000, 8000, 16000, 32000};
  std::vector<std::uint64_t> seeds{1};
  std::vector<std::string> variants;
  std::size_t sources = 8;
  RunSettings settings;
};

/// The far errors of one variant over all runs.
struct Series {
  std::vector<double> epsilon, mean, over, under;
};

void print_run(const TorusTask& task, std::uint64_t seed, const Variant& variant, const DistanceErrors& e,
               double seconds) {
  std::printf("%-9s %7zu %5llu %8.4f  %9.2e %9.2e %9.2e %9.2e %9.2e  %9.2e %9.2e %9.2e %9.1f\n", variant.name.c_str(),
              task.sample.size(), static_cast<unsigned long long>(seed), task.epsilon, e.far.mean, e.far.mean_over,
              e.far.mean_under, e.far.largest_over, e.far.largest_under, e.near.mean, e.near.largest_over,
              e.near.largest_under, seconds);
  std::fflush(stdout);
}

void print_exponents(const Variant& variant, const Series& s) {
  std::printf("%-9s mean %5.2f   over %5.2f   under %5.2f   (%zu runs)\n", variant.name.c_str(),
              fitted_exponent(s.epsilon, s.mean), fitted_exponent(s.epsilon, s.over),
              fitted_exponent(s.epsilon, s.under), s.epsilon.size());
}

void run_variant(const TorusTask& task, std::uint64_t seed, const Variant& variant, RunSettings settings,
                 Series& series) {
  settings.seed = seed;
  try {
    const auto start = std::chrono::steady_clock::now();
    const auto computed = engine_distances(task, variant, settings);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const DistanceErrors errors = distance_errors(task.truth, computed);
    print_run(task, seed, variant, errors, seconds);
    series.epsilon.push_back(task.epsilon), series.mean.push_back(errors.far.mean);
    series.over.push_back(errors.far.mean_over), series.under.push_back(errors.far.mean_under);
  } catch (const SampleError& error) {
    std::printf("%-9s %7zu %5llu %8.4f  refused: %s\n", variant.name.c_str(), task.sample.size(),
                static_cast<unsigned long long>(seed), task.epsilon, error.what());
  }
}

/// Those of the known variants that are asked for; all if none is.
std::vector<Variant> chosen_variants(const AccuracyArguments& arguments) {
  const std::vector<Variant> known = variants_of(arguments.settings.stages);
  if (arguments.variants.empty()) return known;
  std::vector<Variant> chosen;
  for (const std::string& name : arguments.variants) {
    const auto found = std::find_if(known.begin(), known.end(), [&](const Variant& v) { return v.name == name; });
    if (found == known.end()) throw OptionError("unknown variant '" + name + "'");
    chosen.push_back(*found);
  }
  return chosen;
}

void run(const AccuracyArguments& arguments) {
  const std::vector<Variant> variants = chosen_variants(arguments);
  std::vector<Series> series(variants.size());
  double asymmetry = 0;
  std::printf("solver %s, %zu sources\n", arguments.settings.stages.solver.c_str(), arguments.sources);
  std::printf("%-9s %7s %5s %8s  %9s %9s %9s %9s %9s  %9s %9s %9s %9s\n", "variant", "points", "seed", "epsilon",
              "far mean", "over", "under", "max over", "max under", "near mean", "max over", "max under", "seconds");
  for (const std::size_t points : arguments.points)
    for (const std::uint64_t seed : arguments.seeds) {
      const TorusTask task = make_torus_task(points, arguments.sources, seed);
      asymmetry = std::max(asymmetry, task.asymmetry);
      for (std::size_t i = 0; i < variants.size(); ++i)
        run_variant(task, seed, variants[i], arguments.settings, series[i]);
    }
  std::printf("truth: largest |d(a, b) - d(b, a)| among sources %.1e\n", asymmetry);
  std::printf("exponents in epsilon of the far means; proved: over 1 (Lemma 21), under 0.5 (Lemma 20)\n");
  for (std::size_t i = 0; i < variants.size(); ++i) print_exponents(variants[i], series[i]);
}

}  // namespace

void add_accuracy(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<AccuracyArguments>(
      app, action, "accuracy", "Distances on a sampled torus against the true ones.", accuracy_meaning, run);
  add_list(command, "--points", arguments.points, "numbers of points");
  add_list(command, "--seeds", arguments.seeds, "of samples, sources and stages");
  add_list(command, "--variants", arguments.variants,
           "of default, none (decimator_none), insert, printed (query rules); all if not given");
  add_count(command, "--sources", arguments.sources, "random points of each sample");
  command.add_option("--solver", arguments.settings.stages.solver, "an exact solver")->capture_default_str();
  add_stages(command, arguments.settings);
  add_threads(command, arguments.settings);
}

}  // namespace geodrome::bench
