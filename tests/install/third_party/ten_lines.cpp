// SPDX-License-Identifier: MIT
// ten_lines MESH PLUGIN_FOLDER: distances from the first vertex.
#include <geodrome/engine/input.hpp>
#include <geodrome/engine/plugin_host.hpp>
#include <geodrome/shortest_path_solver.hpp>
#include <iostream>

int main(int, char** arguments) {
  using namespace geodrome;
  const Input input = read_input(arguments[1]);
  const auto mesh = std::make_shared<const SurfaceMesh>(input.positions, input.triangles);
  const auto solver = PluginHost({arguments[2]}).load<ShortestPathSolver>("third_party");
  const auto from_first = [&](const auto& s) { return distances(s, mesh, mesh->at_vertex(0)); };
  for (const double d : solver.call(from_first)) std::cout << d << '\n';
}
