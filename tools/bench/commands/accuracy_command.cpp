// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/samples/distance_errors.hpp"
#include "tools/bench/samples/engine_runs.hpp"
#include "tools/bench/solvers/fit.hpp"
#include "tools/bench/solvers/search_figures.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* accuracy_meaning =
    "hole: the largest distance of 100,000 random surface points from the sample. epsilon: the same over the local\n"
    "feature size, where that is known and the same everywhere: sphere 1, torus 0.4, trefoil 0.1. Errors are relative\n"
    "to the true geodesic distance: paths of an exact solver on a mesh of the shape, shortened to geodesics of the\n"
    "shape by Newton's method (error 1e-12), the least of several ways; where there is noise, between the points that\n"
    "it moved along the normal. far: pairs at least a quarter of the largest distance apart; near: less than a\n"
    "twentieth. mean: of |error|; over, under: of the pairs that are too long, too short. Exponents: least squares in\n"
    "log-log over all sizes and seeds of a variant, in the hole, to which epsilon is proportional. Seconds: processor\n"
    "time of a row, from a source to all points, if there are four sources. Of --metric smooth: estimate: the error\n"
    "that the engine states, relative, mean of its rows; ratio: that over the far mean; within, 2x, 4x: the share of\n"
    "far pairs whose error is at most one, two, four estimates; smooth: of the paths' length, what lies on the smooth\n"
    "surface.";

struct AccuracyArguments {
  std::vector<std::string> shapes{"sphere", "torus", "ellipsoid", "trefoil", "genus2", "star", "bumpy"};
  std::vector<std::string> samplings{"uniform"};
  std::vector<std::size_t> points{2000, 8000, 32000};
  std::vector<double> noise{0};
  std::vector<std::uint64_t> seeds{1};
  std::vector<std::string> variants, metrics{"flat"};
  std::size_t sources = 4;
  TruthChoice truth;
  RunSettings settings;
};

/// The far errors of one variant over all sizes and seeds.
struct Series {
  std::vector<double> hole, mean, over, under;
};

const char* word(Metric metric) { return metric == Metric::smooth ? "smooth" : "flat"; }

/// What one row of the table is about.
struct Run {
  const ManifoldTask& task;
  const SampleCase& sample;

  void print_head(const Variant& variant) const {
    const auto size = feature_size(sample.shape);
    std::printf("%-8s %-6s %-8s %7zu %6g %5llu %8.4f %8s", variant.name.c_str(), word(variant.metric),
                sample.sampling.c_str(), task.sample.size(), sample.noise, static_cast<unsigned long long>(sample.seed),
                task.hole, size ? figure_text(task.hole / *size, 4).c_str() : "-");
  }
};

void print_errors(const DistanceErrors& e, const EngineRun& engine) {
  std::printf("  %9.2e %9.2e %9.2e %9.2e %9.2e  %9.2e %9.2e %9.2e %9.4f", e.far.mean, e.far.mean_over, e.far.mean_under,
              e.far.largest_over, e.far.largest_under, e.near.mean, e.near.largest_over, e.near.largest_under,
              engine.row_seconds);
  if (engine.estimated_error)
    std::printf("  %9.2e %7.2f %7.3f %7.3f %7.3f %7.3f", *engine.estimated_error, *engine.estimated_error / e.far.mean,
                e.far.share_within(0), e.far.share_within(1), e.far.share_within(2), *engine.smooth_share);
  std::printf("\n");
}

void print_exponents(const Variant& variant, const Series& s) {
  const auto exponent = [&](const std::vector<double>& y) {
    return figure_text(fitted_exponent(s.hole, y), 2);  // "-" where some mean is 0
  };
  std::printf("%-8s %-6s mean %5s   over %5s   under %5s   (%zu runs)\n", variant.name.c_str(), word(variant.metric),
              exponent(s.mean).c_str(), exponent(s.over).c_str(), exponent(s.under).c_str(), s.hole.size());
}

void run_variant(const Run& run, const Variant& variant, RunSettings settings, Series& series) {
  settings.seed = run.sample.seed;
  run.print_head(variant);
  try {
    const EngineRun engine = engine_distances(run.task, variant, settings);
    const DistanceErrors errors = distance_errors(run.task.truth, engine.distances, engine.estimated_error.value_or(0));
    print_errors(errors, engine);
    series.hole.push_back(run.task.hole), series.mean.push_back(errors.far.mean);
    series.over.push_back(errors.far.mean_over), series.under.push_back(errors.far.mean_under);
  } catch (const SampleError& error) {
    std::printf("  refused: %s\n", error.what());
  }
  std::fflush(stdout);
}

/// Those of the known variants that are asked for, all if none is; each with the metrics that are asked for.
std::vector<Variant> chosen_variants(const AccuracyArguments& arguments) {
  const std::vector<Variant> known = variants_of(arguments.settings.stages);
  for (const std::string& name : arguments.variants)
    if (std::ranges::find(known, name, &Variant::name) == known.end())
      throw OptionError("unknown variant '" + name + "'");
  std::vector<Variant> chosen;
  for (Variant variant : known) {
    if (!arguments.variants.empty() && std::ranges::count(arguments.variants, variant.name) == 0) continue;
    for (const std::string& metric : arguments.metrics) {
      variant.metric = metric == "smooth" ? Metric::smooth : Metric::flat;
      chosen.push_back(variant);
    }
  }
  return chosen;
}

void print_titles(const std::string& shape) {
  std::printf(
      "\n%s\n%-8s %-6s %-8s %7s %6s %5s %8s %8s  %9s %9s %9s %9s %9s  %9s %9s %9s %9s  %9s %7s %7s %7s %7s %7s\n",
      shape.c_str(), "variant", "metric", "sampling", "points", "noise", "seed", "hole", "epsilon", "far mean", "over",
      "under", "max over", "max under", "near mean", "max over", "max under", "seconds", "estimate", "ratio", "within",
      "2x", "4x", "smooth");
}

/// All sizes and seeds of a way to sample, and their exponents.
void run_sizes(TaskMaker& maker, SampleCase sample, const std::vector<Variant>& variants,
               const AccuracyArguments& arguments) {
  std::vector<Series> series(variants.size());
  double asymmetry = 0;
  for (const std::size_t points : arguments.points)
    for (const std::uint64_t seed : arguments.seeds) {
      sample.points = points, sample.seed = seed;
      const ManifoldTask task = maker.make(sample, arguments.sources);
      asymmetry = std::max(asymmetry, task.asymmetry);
      for (std::size_t i = 0; i < variants.size(); ++i)
        run_variant({task, sample}, variants[i], arguments.settings, series[i]);
    }
  std::printf("truth: largest |d(a, b) - d(b, a)| among sources %.1e\n", asymmetry);
  if (arguments.points.size() * arguments.seeds.size() < 2) return;
  std::printf("exponents in epsilon of the far means; proved: over 1 (Lemma 21), under 0.5 (Lemma 20)\n");
  for (std::size_t i = 0; i < variants.size(); ++i) print_exponents(variants[i], series[i]);
}

void run(const AccuracyArguments& arguments) {
  const PluginHost host(arguments.settings.plugin_path);
  const std::vector<Variant> variants = chosen_variants(arguments);
  std::printf("solver %s, %zu sources\n", arguments.settings.stages.solver.c_str(), arguments.sources);
  for (const std::string& shape : arguments.shapes) {
    TaskMaker maker(shape, arguments.truth, host);
    print_titles(shape);
    for (const std::string& sampling : arguments.samplings)
      for (const double noise : arguments.noise)
        run_sizes(maker, {.shape = shape, .sampling = sampling, .noise = noise}, variants, arguments);
  }
}

}  // namespace

void add_accuracy(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<AccuracyArguments>(
      app, action, "accuracy", "Distances on sampled surfaces against the true ones.", accuracy_meaning, run);
  add_list(command, "--shapes", arguments.shapes, "smooth closed shapes")->check(CLI::IsMember(smooth_shapes()));
  add_list(command, "--samplings", arguments.samplings, "of uniform, blue, grid, loose");
  add_list(command, "--points", arguments.points, "numbers of points");
  add_list(command, "--noise", arguments.noise, "standard deviations along the normal, as shares of the diagonal");
  add_list(command, "--seeds", arguments.seeds, "of samples, sources and stages");
  add_list(command, "--variants", arguments.variants,
           "of default, none (decimator_none), insert, printed (query rules); all if not given");
  add_list(command, "--metric", arguments.metrics, "of flat, smooth; side by side")
      ->check(CLI::IsMember({"flat", "smooth"}));
  add_count(command, "--sources", arguments.sources, "random points of each sample");
  add_truth(command, arguments.truth);
  add_count(command, "--near", arguments.truth.near, "more targets of a source that are near it");
  command.add_option("--solver", arguments.settings.stages.solver, "an exact solver")->capture_default_str();
  add_stages(command, arguments.settings);
  add_threads(command, arguments.settings);
}

}  // namespace geodrome::bench
