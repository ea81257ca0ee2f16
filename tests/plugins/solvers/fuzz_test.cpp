// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/exactness_fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

namespace geodrome::test {
namespace {

/// Ten meshes a test; the parameter is the last digit but one of their seeds.
class FuzzMeshes : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(FuzzMeshes, AreSolvedExactly) {
  const auto& [solver, ten] = GetParam();
  for (std::uint64_t seed = 10 * ten + 1; seed <= 10u * ten + 10; ++seed) {
    const shapes::FuzzMesh fuzz = shapes::fuzz_mesh(seed);
    expect_exact(solver, "fuzz:" + std::to_string(seed) + " (" + fuzz.recipe + ")", share(fuzz.mesh),
                 {.sources = 3, .points = 60, .seed = seed, .seconds = 60});
  }
}

std::string test_name(const testing::TestParamInfo<std::tuple<std::string, int>>& info) {
  return std::get<0>(info.param) + "_from_" + std::to_string(10 * std::get<1>(info.param) + 1);
}

INSTANTIATE_TEST_SUITE_P(Plugins, FuzzMeshes,
                         testing::Combine(testing::ValuesIn(judged_solvers()), testing::Range(0, 10)), test_name);

}  // namespace
}  // namespace geodrome::test
