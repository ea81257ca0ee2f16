// SPDX-License-Identifier: MIT
// Exact solvers on real meshes: needles, handles, holes, a terrain, defects. The small ones against CGAL too.
#include <filesystem>

#include "geodrome/engine/input.hpp"
#include "tests/plugins/solvers/exactness_fixture.hpp"

namespace geodrome::test {
namespace {

const std::filesystem::path meshes = std::filesystem::path(GEODROME_SHARED_DATA) / "meshes";

/// The mesh of a file with its own numbers; null where the data are absent.
MeshPtr real_mesh(const std::string& file) {
  if (!std::filesystem::exists(meshes / file)) return nullptr;
  Input input = read_input((meshes / file).string());
  return share(SurfaceMesh(std::move(input.positions), std::move(input.triangles)));
}

class RealMesh : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(RealMesh, IsSolvedExactly) {
  const auto& [solver, file] = GetParam();
  const MeshPtr mesh = real_mesh(file);
  if (!mesh) GTEST_SKIP() << file << " is not there";
  constexpr std::size_t quick_for_cgal = 5000;
  const Plugin<ShortestPathSolver> judged = load_solver(solver), peer = load_solver("cgal");
  const bench::ExactnessOptions options{.sources = 2, .points = 100, .seed = 7};
  const bench::Exactness result =
      bench::judge(judged, mesh->face_count() <= quick_for_cgal ? &peer : nullptr, mesh, options);
  EXPECT_TRUE(result.exact()) << bench::exactness_names() << "\n"
                              << bench::exactness_figures(result) << "\n"
                              << bench::exactness_notes(result);
}

/// A vertex beside the boundary that wavefronts kept as whole sequences can lose.
TEST(RealMeshMountain, ReachesTheVertexBesideTheBoundary) {
  const MeshPtr mesh = real_mesh("mountain.ply");
  if (!mesh) GTEST_SKIP() << "mountain.ply is not there";
  for (const std::string& solver : judged_solvers())
    for (const Index source : {5, 11}) {
      const std::vector<double> from_source = from_vertex(load_solver(solver), mesh, source);
      const std::vector<double> back = from_vertex(load_solver(solver), mesh, 123);
      EXPECT_NEAR(from_source[123], back[source], 1e-12 * back[source]) << solver << " " << source;
    }
}

INSTANTIATE_TEST_SUITE_P(Files, RealMesh,
                         testing::Combine(testing::ValuesIn(judged_solvers()),
                                          testing::Values("fish_low.obj", "tray_bottom.stl", "cheese.off",
                                                          "plane_holes.obj", "cortex_fsaverage5_lh.ply",
                                                          "cycloidal_defects.ply")),
                         [](const auto& info) {
                           std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

}  // namespace
}  // namespace geodrome::test
