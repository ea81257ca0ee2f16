// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "geodrome/engine/input.hpp"
#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/audit_figures.hpp"
#include "tools/bench/solvers/list.hpp"
#include "tools/bench/solvers/own_process.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* audit_meaning =
    "Jobs of distances to all vertices, on one thread, with a matrix or with the nearest of their sources. Cost: a "
    "job\n"
    "without and with its audit by turns, each in a process of its own, from reading the mesh to the files written:\n"
    "seconds of processors and peak of resident memory, medians over the rounds. Power, for the faulty solvers that\n"
    "are named: at how many seeds a job with the audit breaks a promise, and without it, by its other checks alone;\n"
    "each seed draws the sources, and the faults of faulty_some_faces. Build with the release preset.";

struct AuditArguments {
  std::string mesh;
  Rivals rivals;
  std::string faulty;
  std::vector<std::string> sources{"1", "10"};
  std::size_t rounds = 5, seeds = 20;
  double share = 0.01;
};

/// The mesh as a file, written by a child so that this process stays small.
class MeshFile {
 public:
  explicit MeshFile(const std::string& mesh) {
    std::string name = (std::filesystem::temp_directory_path() / "geodrome_bench_XXXXXX").string();
    if (!mkdtemp(name.data())) throw RefusedError("no folder can be made in " + name);
    folder_ = name;
    in_a_process_of_its_own([&] {
      const MeshPtr made = load_mesh(mesh);
      write_mesh(file(), *made);
      std::ofstream(folder_ / "vertices") << made->vertex_count();
      std::printf("%s: %zu faces, %zu vertices\n", mesh.c_str(), made->face_count(), made->vertex_count());
    });
    std::ifstream(folder_ / "vertices") >> vertices_;
  }
  ~MeshFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  MeshFile(const MeshFile&) = delete;
  MeshFile& operator=(const MeshFile&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path file() const { return folder_ / "mesh.ply"; }
  std::size_t vertices() const { return vertices_; }

 private:
  std::filesystem::path folder_;
  std::size_t vertices_ = 0;
};

/// Rows spread evenly over the vertices; "all" of them.
std::string spread_rows(const std::string& count, std::size_t vertices) {
  if (count == "all") return count;
  const std::size_t wanted = std::stoul(count);
  std::string rows;
  for (std::size_t i = 0; i < wanted; ++i)
    rows += (i > 0 ? "," : "") + std::to_string((2 * i + 1) * vertices / (2 * wanted));
  return rows;
}

void print_costs(const AuditJobs& jobs, const AuditArguments& arguments, std::size_t vertices) {
  std::printf("%-8s %-8s %10s %10s %7s %10s %10s %7s\n", "sources", "output", "job s", "audited s", "ratio", "job MB",
              "audited MB", "ratio");
  for (const std::string& count : arguments.sources)
    for (const bool nearest : {false, true}) {
      const AuditCost cost = audit_cost(jobs, spread_rows(count, vertices), nearest, arguments.rounds);
      std::printf("%-8s %-8s %10.3f %10.3f %7.2f %10.1f %10.1f %7.2f\n", count.c_str(), nearest ? "nearest" : "matrix",
                  cost.seconds, cost.audited_seconds, cost.audited_seconds / cost.seconds, 1e-6 * cost.bytes,
                  1e-6 * cost.audited_bytes, cost.audited_bytes / cost.bytes);
      std::fflush(stdout);
    }
}

void print_powers(AuditJobs jobs, const AuditArguments& arguments, std::size_t vertices) {
  std::printf("%-48s %-8s %-8s %10s %10s of %zu seeds\n", "faulty solver", "sources", "output", "audited", "without",
              arguments.seeds);
  for (const std::string& solver : split_solvers(arguments.faulty))
    for (const std::string& count : arguments.sources)
      for (const bool nearest : {false, true}) {
        if (count == "all") continue;
        jobs.solver = solver;
        const AuditPower power = audit_power(jobs, vertices, std::stoul(count), nearest, arguments.seeds);
        std::printf("%-48s %-8s %-8s %10zu %10zu\n", solver.c_str(), count.c_str(), nearest ? "nearest" : "matrix",
                    power.found, power.found_without);
        std::fflush(stdout);
      }
}

void run(const AuditArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  for (const std::string& solver : split_solvers(arguments.rivals.solver + "," + arguments.faulty))
    host.load<ShortestPathSolver>(solver);
  const MeshFile mesh(arguments.mesh);
  const AuditJobs jobs{.mesh = mesh.file(),
                       .folder = mesh.folder(),
                       .plugin_path = arguments.rivals.plugin_path,
                       .solver = arguments.rivals.solver,
                       .share = arguments.share};
  if (arguments.faulty.empty()) return print_costs(jobs, arguments, mesh.vertices());
  print_powers(jobs, arguments, mesh.vertices());
}

}  // namespace

void add_audit(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<AuditArguments>(
      app, action, "audit", "What the audit of a distance job costs, and which faults it finds.", audit_meaning, run);
  add_mesh(command, arguments.mesh);
  add_solver(command, arguments.rivals);
  command.add_option("--faulty", arguments.faulty, "measures the power, on NAME[:key=value,...][,NAME...]");
  add_list(command, "--sources", arguments.sources, "how many, or all (cost alone)")
      ->check(CLI::PositiveNumber | CLI::IsMember({"all"}));
  add_count(command, "--rounds", arguments.rounds, "of jobs without and with the audit");
  add_count(command, "--seeds", arguments.seeds, "of sources and faults");
  command.add_option("--share", arguments.share, "of the faces, which is audited")->capture_default_str();
}

}  // namespace geodrome::bench
