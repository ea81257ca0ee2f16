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
  EXPECT_LT(windows_an_edge(mesh, "merged_windows:delta=1e-2"), windows_an_edge(mesh, "merged_windows:delta=1e-4"));
  EXPECT_LT(windows_an_edge(mesh, "merged_windows:delta=1e-4"), windows_an_edge(mesh, "chen_han"));
}

/// Where merges are refused, the run begins again with exact windows; its answers are those of chen_han.
TEST(MergedWindows, GiveWayToExactOnesWhereListsStayLong) {
  const MeshPtr mesh = shape("jittered-torus", 20000);
  EXPECT_EQ(windows_an_edge(mesh, "merged_windows:delta=1e-6"), windows_an_edge(mesh, "chen_han"));
  const std::vector<double> exact = from_vertex(load_solver("chen_han"), mesh, 7);
  EXPECT_EQ(from_vertex(load_solver("merged_windows:delta=1e-6"), mesh, 7), exact);
  EXPECT_NE(from_vertex(load_solver("merged_windows:delta=1e-2"), mesh, 7), exact);
}

}  // namespace
}  // namespace geodrome::test
