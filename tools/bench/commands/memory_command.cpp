// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "engine/report/memory.hpp"
#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/memory.hpp"
#include "tools/bench/solvers/own_process.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* memory_meaning =
    "Every line is a process of its own that loads the plugin and the mesh, returns to the system what was freed on\n"
    "the way, then prepares the surface, searches once from a random vertex and copies all vertex distances. before:\n"
    "resident memory (VmRSS) ahead of that, with mesh, plugins and program. peak: the largest (VmHWM) from then on.\n"
    "added: the difference, all that the solver costs a user beside the mesh: prepared surface, search, distances,\n"
    "what is only needed for a while, what allocator and system round up or hold back, and code that is first run\n"
    "there; memory that was asked for but never touched is not in it. On meshes of a few thousand faces code and\n"
    "rounding are most of it. prepared: PreparedSurface::bytes(). search: the solver's counter largest_search_bytes;\n"
    "-: not counted. keep: targets, distances of vertices only; map, any point and paths.";

struct MemoryArguments {
  std::string mesh;
  Rivals rivals{.peer = "none"};
  std::vector<std::string> keep{"targets"};
  std::uint64_t seed = 1;
};

double megabytes(std::size_t bytes) { return 1e-6 * static_cast<double>(bytes); }

void print_memory(const std::string& name, const std::string& keep, const MemoryArguments& arguments) {
  const auto solver = PluginHost(arguments.rivals.plugin_path).load<ShortestPathSolver>(name);
  const MeshPtr mesh = load_mesh(arguments.mesh);
  const Index source = choose_sources(*mesh, 1, arguments.seed).front();
  const SearchMemory memory = search_memory(solver, mesh, source, keep == "map" ? Keep::map : Keep::targets);
  std::printf("%-24s %-8s %9zu %10.2f %10.2f %10.2f %12.2f %10s\n", solver.info.full_name().c_str(), keep.c_str(),
              mesh->face_count(), megabytes(memory.before), megabytes(memory.peak), megabytes(memory.added()),
              megabytes(memory.prepared), figure_text(quotient(memory.search, 1e6), 2).c_str());
}

void run(const MemoryArguments& arguments) {
  if (!reset_memory_peak()) std::printf("peaks cannot be reset here: they include the loading of the mesh\n");
  std::printf("%-24s %-8s %9s %10s %10s %10s %12s %10s\n", "solver", "keep", "faces", "before MB", "peak MB",
              "added MB", "prepared MB", "search MB");
  for (const std::string& keep : arguments.keep)
    for (const std::string& name : {arguments.rivals.solver, arguments.rivals.peer})
      if (name != "none") in_a_process_of_its_own([&] { print_memory(name, keep, arguments); });
}

}  // namespace

void add_memory(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command<MemoryArguments>(app, action, "memory", "Memory of one search on one mesh.", memory_meaning, run);
  add_mesh(command, arguments.mesh);
  add_solver(command, arguments.rivals);
  add_peer(command, arguments.rivals, "another solver, or none");
  add_list(command, "--keep", arguments.keep, "of targets, map")->check(CLI::IsMember({"targets", "map"}));
  command.add_option("--seed", arguments.seed, "chooses the source")->capture_default_str();
}

}  // namespace geodrome::bench
