// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/growth.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* meaning =
    "One thread. A query is one search from a vertex and the copy of all vertex distances; the search is made once a\n"
    "mesh and has had one query from that source before the clock starts. Windows: the solver's counter\n"
    "windows_propagated; search MB: its counter largest_search_bytes, without the prepared surface and the mesh; -:\n"
    "not counted. Windows and seconds are medians over the sources (seconds: over the runs of a source first), bytes\n"
    "the largest. Exponents: least squares in log-log over the real numbers of faces. Shapes come in steps of their\n"
    "own: sizes that give the same mesh come once. Wall-clock time: let nothing else run. Build with the release\n"
    "preset.";

struct GrowthArguments {
  std::string solver = "chen_han";
  std::vector<std::string> shapes{"icosphere", "jittered-torus", "bumpy", "noisy-sphere"};
  std::vector<std::size_t> faces{10'000, 50'000, 200'000, 800'000};
  std::vector<std::filesystem::path> plugin_path;
  GrowthOptions options;
};

void run_shape(const std::string& shape, const Plugin<ShortestPathSolver>& solver, const GrowthArguments& arguments) {
  std::vector<GrowthPoint> points;
  for (const std::size_t faces : arguments.faces) {
    const auto mesh = std::make_shared<const SurfaceMesh>(shapes::mesh(shape, faces, arguments.options.seed));
    const auto same = [&](const GrowthPoint& point) { return point.faces == mesh->face_count(); };
    if (std::any_of(points.begin(), points.end(), same)) continue;
    points.push_back(growth_point(solver, mesh, arguments.options));
    print(std::cout, shape, points.back());
  }
  print(std::cout, shape, exponents_of(points));
}

void run(const GrowthArguments& arguments) {
  const auto solver = PluginHost(arguments.plugin_path).load<ShortestPathSolver>(arguments.solver);
  std::cout << solver.info.full_name() << "; " << arguments.options.sources << " sources, " << arguments.options.runs
            << " runs\n";
  print_growth_head(std::cout);
  for (const std::string& shape : arguments.shapes) run_shape(shape, solver, arguments);
}

}  // namespace

void add_growth(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<GrowthArguments>();
  CLI::App& command = *app.add_subcommand("growth", "How a solver's windows and time grow with the mesh.");
  command.footer(meaning);
  const auto list = [&](const char* flag, auto& values, const char* help) {
    return command.add_option(flag, values, help)->delimiter(',')->allow_extra_args(false)->capture_default_str();
  };
  command.add_option("--solver", arguments->solver, "NAME[:key=value,...]")->capture_default_str();
  list("--shapes", arguments->shapes, "kinds of mesh")->check(CLI::IsMember(shapes::mesh_kinds()));
  list("--faces", arguments->faces, "numbers of faces, about")->check(CLI::PositiveNumber);
  command.add_option("--sources", arguments->options.sources, "random vertices")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--runs", arguments->options.runs, "runs per source")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command.add_option("--seed", arguments->options.seed, "of the meshes; chooses the sources")->capture_default_str();
  command.add_option("--plugin-path", arguments->plugin_path, "folder searched first (may be repeated)")
      ->allow_extra_args(false);
  command.callback([&action, arguments] { action = [arguments] { run(*arguments); }; });
}

}  // namespace geodrome::bench
