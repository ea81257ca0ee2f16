// SPDX-License-Identifier: MIT
#include <iostream>

#include "tools/bench/commands/bench_mesh.hpp"
#include "tools/bench/commands/commands.hpp"
#include "tools/bench/solvers/matrix_rows.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* matrix_meaning =
    "Rows of a matrix of all vertices, by what the solver prepares for all of them together, against plain rows by\n"
    "the peer, which may be the same solver or the file of another build. Both in one process and one run, chunk of\n"
    "rows by chunk: A B B A. A row is a search from a vertex and the copy of all vertex distances; searches are used\n"
    "again and have made one row before the clock starts. Seconds are those of processors, all threads together;\n"
    "preparing is apart, and part of the whole matrix, whose other rows are taken to cost what those made did.\n"
    "Difference: of the two in the same entry; asymmetry: of the solver's D(i, j) and D(j, i), among the rows made.\n"
    "--sources 0 makes all rows, and holds half of the matrix in memory. Build with the release preset.";

struct MatrixArguments {
  std::string mesh;
  Rivals rivals{.solver = "chen_han", .peer = "chen_han", .plugin_path = {}};
  MatrixRowsOptions options;
};

void run(const MatrixArguments& arguments) {
  const PluginHost host(arguments.rivals.plugin_path);
  const auto solver = host.load<ShortestPathSolver>(arguments.rivals.solver);
  const auto peer = host.load<ShortestPathSolver>(arguments.rivals.peer);
  const MeshPtr mesh = load_mesh(arguments.mesh);
  std::cout << arguments.mesh << ": " << mesh->face_count() << " faces, " << mesh->vertex_count() << " vertices\n";
  print(std::cout, matrix_rows(solver, peer, mesh, arguments.options));
}

}  // namespace

void add_matrix(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<MatrixArguments>(
      app, action, "matrix", "Rows of a matrix prepared together against plain ones.", matrix_meaning, run);
  MatrixRowsOptions& options = arguments.options;
  add_mesh(command, arguments.mesh);
  add_solver(command, arguments.rivals);
  add_peer(command, arguments.rivals, "NAME[:key=value,...], or the path of a plugin's file");
  command.add_option("--sources", options.rows, "random vertices; 0: all")->capture_default_str();
  add_count(command, "--chunk", options.chunk, "rows that one makes before the other has its turn");
  command.add_option("--threads", options.threads, "0: one per core")->capture_default_str();
  command.add_option("--radius", options.radius, "of all searches")->check(CLI::PositiveNumber);
  command.add_flag("--of-rows-alone", options.of_rows_alone, "the plan holds the rows made, not all vertices");
  command.add_option("--seed", options.seed, "chooses the rows")->capture_default_str();
}

}  // namespace geodrome::bench
