// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/growth.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* growth_meaning =
    "One thread. A query is one search from a vertex and the copy of all vertex distances; the search is made once a\n"
    "mesh and has had one query from that source before the clock starts. Windows: the solver's counter\n"
    "windows_propagated; search MB: its counter largest_search_bytes, without the prepared surface and the mesh; -:\n"
    "not counted. Windows and seconds are medians over the sources (seconds: over the runs of a source first), bytes\n"
    "the largest. Exponents: least squares in log-log over the real numbers of faces. Shapes come in steps of their\n"
    "own: sizes that give the same mesh come once. Wall-clock time: let nothing else run. Build with the release\n"
    "preset.";

struct GrowthArguments {
  Rivals rivals;
  std::vector<std::string> shapes{"icosphere", "jittered-torus", "bumpy", "noisy-sphere"};
  std::vector<std::size_t> faces{10'000, 50'000, 200'000, 800'000};
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
  const auto solver = PluginHost(arguments.rivals.plugin_path).load<ShortestPathSolver>(arguments.rivals.solver);
  std::cout << solver.info.full_name() << "; " << arguments.options.sources << " sources, " << arguments.options.runs
            << " runs\n";
  print_growth_head(std::cout);
  for (const std::string& shape : arguments.shapes) run_shape(shape, solver, arguments);
}

}  // namespace

void add_growth(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<GrowthArguments>(
      app, action, "growth", "How a solver's windows and time grow with the mesh.", growth_meaning, run);
  add_solver(command, arguments.rivals);
  add_list(command, "--shapes", arguments.shapes, "kinds of mesh")->check(CLI::IsMember(shapes::mesh_kinds()));
  add_list(command, "--faces", arguments.faces, "numbers of faces, about")->check(CLI::PositiveNumber);
  add_count(command, "--sources", arguments.options.sources, "random vertices");
  add_count(command, "--runs", arguments.options.runs, "runs per source");
  command.add_option("--seed", arguments.options.seed, "of the meshes; chooses the sources")->capture_default_str();
}

}  // namespace geodrome::bench
