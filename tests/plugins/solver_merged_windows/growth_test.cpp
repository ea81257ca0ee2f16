// SPDX-License-Identifier: MIT
#include <string_view>

#include "tests/plugins/solvers/fixture.hpp"

/// What makes the solver fast: on smooth fine meshes about one window crosses an edge, however many faces there are.
namespace geodrome::test {
namespace {

double windows_an_edge(const MeshPtr& mesh, const std::string& solver) {
  const Plugin<ShortestPathSolver> plugin = load_solver(solver);
  QuietContext context;
  const auto prepared = plugin.object->prepare(mesh, context);
  const auto search = prepared->make_search();
  const Source source{mesh->at_vertex(0), 0};
  for (const Counter& counter : search->run({&source, 1}, {}, context).counters())
    if (std::string_view(counter.name) == "windows_propagated")
      return static_cast<double>(counter.value) / (1.5 * static_cast<double>(mesh->face_count()));
  ADD_FAILURE() << "no counter";
  return 0;
}

TEST(MergedWindows, AreAboutOneAnEdgeOnSmoothMeshes) {
  for (const std::size_t faces : {5000, 20000, 80000}) {
    EXPECT_LT(windows_an_edge(shape("icosphere", faces), "merged_windows"), 1.5) << faces;
    EXPECT_LT(windows_an_edge(shape("jittered-torus", faces), "merged_windows"), 1.7) << faces;
    EXPECT_LT(windows_an_edge(shape("bumpy", faces), "merged_windows"), 1.6) << faces;
  }
}

TEST(MergedWindows, AreMoreTheSmallerDeltaIs) {
  const MeshPtr mesh = shape("jittered-torus", 20000);
  EXPECT_LT(windows_an_edge(mesh, "merged_windows:delta=1e-2"), windows_an_edge(mesh, "merged_windows:delta=1e-5"));
  EXPECT_LT(windows_an_edge(mesh, "merged_windows:delta=1e-5"), windows_an_edge(mesh, "chen_han"));
}

}  // namespace
}  // namespace geodrome::test
