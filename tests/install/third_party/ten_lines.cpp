// SPDX-License-Identifier: MIT
#include <geodrome/engine/plugin_host.hpp>
#include <geodrome/shortest_path_solver.hpp>
#include <iostream>

int main(int, char** arguments) {
  using namespace geodrome;
  const auto mesh = std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}},
                                                        std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}});
  const auto solver = PluginHost({arguments[1]}).load<ShortestPathSolver>("third_party");
  for (const double d : distances(*solver.object, mesh, mesh->at_vertex(0))) std::cout << d << '\n';
}
