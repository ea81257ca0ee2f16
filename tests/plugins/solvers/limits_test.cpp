// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/limits_fixture.hpp"

namespace geodrome::test {
namespace {

class LimitedSolver : public testing::TestWithParam<std::string> {};

/// Behind windows that are not shortest paths, a list is nearer inside than its outer ends tell.
TEST_P(LimitedSolver, FindsWhatIsNearerInsideAListThanAtItsEnds) {
  struct Case {
    std::uint64_t seed;
    Index source;
    double radius;
  };
  shapes::Random random(880);
  for (const Case& one :
       {Case{42, 265, 11.206482}, Case{42, 238, 17.956935}, Case{262, 343, 6.567359}, Case{262, 245, 13.959791},
        Case{344, 120, 296.108496}, Case{355, 199, 18.906834}, Case{884, 6, 115.09322}}) {
    const MeshPtr mesh = fuzzed(one.seed);
    LimitJudge judge(GetParam(), mesh);
    const std::vector<Source> sources{{mesh->at_vertex(one.source)}};
    judge.truth(sources, random);
    judge.expect_radius(sources, one.radius);
  }
}

TEST_P(LimitedSolver, GivesWithinALimitWhatItGivesWithoutOne) {
  shapes::Random random(881);
  std::vector<std::uint64_t> seeds{42, 70, 262, 344, 355, 884, 914};
  for (std::uint64_t seed = 1; seed <= 30; ++seed) seeds.push_back(seed);
  for (const std::uint64_t seed : seeds) {
    LimitJudge judge(GetParam(), fuzzed(seed));
    expect_limits_change_nothing(judge, fuzzed(seed), random);
    if (HasFatalFailure()) FAIL() << "fuzz:" << seed;
  }
  for (const MeshPtr& mesh : random_meshes(5)) {
    LimitJudge judge(GetParam(), mesh);
    expect_limits_change_nothing(judge, mesh, random);
  }
}

INSTANTIATE_TEST_SUITE_P(Plugins, LimitedSolver, testing::Values("chen_han", "schreiber"), solver_name);

}  // namespace
}  // namespace geodrome::test
