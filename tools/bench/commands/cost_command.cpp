// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <memory>

#include "engine/report/memory.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/samples/stage_costs.hpp"
#include "tools/bench/solvers/own_process.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* cost_meaning =
    "Points of the torus R = 1, r = 0.4, uniform by area. One thread; every size in a process of its own. Peak: the "
    "largest\n"
    "resident memory of that process while the stage ran, with the sample and what earlier stages left. Wall-clock "
    "time: let\n"
    "nothing else run. Build with the release preset.";

struct CostArguments {
  std::vector<std::size_t> points{10'000, 100'000, 1'000'000};
  std::uint64_t seed = 1;
  RunSettings settings;
};

void print_line(std::size_t points, const std::string& name, double seconds, std::size_t peak) {
  std::printf("%9zu  %-32s %10.3f %12.2f %10.1f\n", points, name.c_str(), seconds,
              1e6 * seconds / static_cast<double>(points), 1e-6 * static_cast<double>(peak));
}

void print_costs(std::size_t points, const CostArguments& arguments) {
  const PluginHost host(arguments.settings.plugin_path);
  const PointSample sample = shapes::sample("torus", {.points = points, .seed = arguments.seed});
  double seconds = 0;
  std::size_t peak = 0;
  for (const StageCost& cost : stage_costs(sample, host, arguments.settings.stages)) {
    print_line(points, cost.plugin, cost.seconds, cost.peak);
    seconds += cost.seconds, peak = std::max(peak, cost.peak);
  }
  print_line(points, "all", seconds, peak);
}

void run(const CostArguments& arguments) {
  if (!reset_memory_peak()) std::printf("peaks cannot be reset here: each is the largest since the process began\n");
  std::printf("%9s  %-32s %10s %12s %10s\n", "points", "stage", "seconds", "us a point", "peak MB");
  for (const std::size_t points : arguments.points) in_a_process_of_its_own([&] { print_costs(points, arguments); });
}

}  // namespace

void add_cost(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command<CostArguments>(app, action, "cost", "Time and memory of stages 1 to 4.", cost_meaning, run);
  add_list(command, "--points", arguments.points, "numbers of points");
  command.add_option("--seed", arguments.seed, "of the sample")->capture_default_str();
  add_stages(command, arguments.settings);
}

}  // namespace geodrome::bench
