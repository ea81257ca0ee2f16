// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/exactness.hpp"
#include "tools/shapes/refine.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* exactness_meaning =
    "Differences are relative to the largest distance from their source, but for `relative`. vertices, points: from "
    "the\n"
    "peer, where neither was proven wrong. paths: length of the path against the distance. together: all sources at "
    "once,\n"
    "with start distances, against the single runs. scaled: the mesh times 1, 1e-6, 1e6, targets only. lipschitz, "
    "a.paths:\n"
    "the audit of all faces. peer x: places where the peer was proven wrong, by at most so much: the solver is shorter "
    "and\n"
    "its path measures so, or the peer is shorter than its own path. wrong: places where the solver is wrong. Status 1 "
    "if a\n"
    "difference is above 1e-12, one of the audit above 1e-11, or the solver failed.";

struct ExactnessArguments {
  std::vector<std::string> meshes;
  std::string refine;
  Rivals rivals;
  std::size_t faces = 0;
  ExactnessOptions options;
};

MeshPtr refined(const MeshPtr& mesh, const ExactnessArguments& arguments) {
  const std::size_t faces = arguments.faces ? arguments.faces : 4 * mesh->face_count();
  return std::make_shared<const SurfaceMesh>(arguments.refine == "midpoint"
                                                 ? shapes::refine_by_midpoints(*mesh, faces)
                                                 : shapes::refine_by_points(*mesh, faces, arguments.options.seed));
}

void run(const ExactnessArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  const auto solver = host.load<ShortestPathSolver>(arguments.rivals.solver);
  const auto peer = load_peer(host, arguments.rivals.peer);
  std::printf("%-32s %8s %s\n", "mesh", "faces", exactness_names().c_str());
  std::size_t failures = 0;
  for (const std::string& name : arguments.meshes) {
    const MeshPtr mesh = load_mesh(name), judged = arguments.refine.empty() ? mesh : refined(mesh, arguments);
    const Exactness result = arguments.refine.empty()
                                 ? judge(solver, peer ? &*peer : nullptr, mesh, arguments.options)
                                 : judge_refined(solver, peer ? &*peer : nullptr, mesh, judged, arguments.options);
    std::printf("%-32s %8zu %s%s\n%s", name.c_str(), judged->face_count(), exactness_figures(result).c_str(),
                result.exact() ? "" : "  NOT EXACT", exactness_notes(result).c_str());
    std::fflush(stdout);
    failures += !result.exact();
  }
  if (failures) throw NumericalError(std::to_string(failures) + " meshes failed");
}

}  // namespace

void add_exactness(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<ExactnessArguments>(
      app, action, "exactness", "Whether a solver is exact on meshes: one row each.", exactness_meaning, run);
  ExactnessOptions& options = arguments.options;
  add_meshes(command, arguments.meshes);
  add_solver(command, arguments.rivals);
  add_peer(command, arguments.rivals, "NAME[:key=value,...], or none");
  add_count(command, "--sources", options.sources, "at a vertex, inside a face, on an edge, in turn");
  add_judging(command, options);
  command
      .add_option("--refine", arguments.refine,
                  "judge on a finer mesh of the same surface, by the peer on the coarse one")
      ->check(CLI::IsMember({"midpoint", "points"}));
  command.add_option("--faces", arguments.faces, "of the finer mesh, at least; four times as many by default");
}

}  // namespace geodrome::bench
