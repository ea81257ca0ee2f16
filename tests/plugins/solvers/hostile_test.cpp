// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/exactness_fixture.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/refine.hpp"

namespace geodrome::test {
namespace {

class HostileMesh : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  const std::string& solver() const { return std::get<0>(GetParam()); }
  const std::string& family() const { return std::get<1>(GetParam()); }

  void expect_exact_on_size(std::size_t size, std::size_t sources) const {
    expect_exact(solver(), "hostile:" + family() + ":" + std::to_string(size), share(shapes::hostile(family(), size)),
                 {.sources = sources, .points = 100});
  }
};

TEST_P(HostileMesh, IsSolvedExactlyWhenSmall) {
  const bool is_fan = family() == "needle-cone" || family() == "needle-saddle";
  expect_exact_on_size(0, is_fan ? 1 : 3);  // CGAL takes seconds a source on fans
}

TEST_P(HostileMesh, IsSolvedExactlyWhenLarger) {
  if (family() == "needle-cone" || family() == "needle-saddle")
    GTEST_SKIP() << "CGAL takes a minute a source; geodrome-bench exactness hostile:" << family() << ":1";
  expect_exact_on_size(1, 2);
}

/// On a finer mesh of the same surface, against the peer on the coarse one.
TEST_P(HostileMesh, IsSolvedExactlyWhenRefined) {
  const MeshPtr coarse = share(shapes::hostile(family(), 0));
  if (coarse->face_count() > 2000) GTEST_SKIP() << "CGAL takes seconds a source";
  const Plugin<ShortestPathSolver> judged = load_solver(solver()), peer = load_solver("cgal");
  const std::size_t faces = 3 * coarse->face_count();
  for (const MeshPtr& finer :
       {share(shapes::refine_by_midpoints(*coarse, faces)), share(shapes::refine_by_points(*coarse, faces, 1))}) {
    const bench::Exactness result = bench::judge_refined(judged, &peer, coarse, finer, {.sources = 1});
    EXPECT_TRUE(result.exact()) << bench::exactness_names() << "\n"
                                << bench::exactness_figures(result) << "\n"
                                << bench::exactness_notes(result);
  }
}

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const shapes::HostileFamily& family : shapes::hostile_families()) names.push_back(family.name);
  return names;
}

std::string test_name(const testing::TestParamInfo<std::tuple<std::string, std::string>>& info) {
  std::string name = std::get<0>(info.param) + "_" + std::get<1>(info.param);
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Plugins, HostileMesh,
                         testing::Combine(testing::ValuesIn(judged_solvers()), testing::ValuesIn(family_names())),
                         test_name);

}  // namespace
}  // namespace geodrome::test
