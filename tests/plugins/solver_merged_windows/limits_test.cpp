// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/limits_fixture.hpp"

namespace geodrome::test {
namespace {

TEST(MergedWindows, KeepTheFactorWithinALimit) {
  shapes::Random random(882);
  for (const std::uint64_t seed : {42, 70, 89, 262, 344, 884})
    for (const auto& [delta, factor] : {std::pair{"0.3", 1.3}, std::pair{"0.01", 1.01}}) {
      const MeshPtr mesh = fuzzed(seed);
      LimitJudge judge(std::string("merged_windows:delta=") + delta, mesh, factor);
      expect_limits_change_nothing(judge, mesh, random);
      if (HasFatalFailure()) FAIL() << "fuzz:" << seed;
    }
  for (const MeshPtr& mesh : random_meshes(6)) {
    LimitJudge judge("merged_windows:delta=0.1", mesh, 1.1);
    expect_limits_change_nothing(judge, mesh, random);
  }
}

TEST(MergedWindows, FindWhatIsNearerInsideAListThanAtItsEnds) {
  shapes::Random random(883);
  const MeshPtr mesh = fuzzed(262);
  LimitJudge judge("merged_windows:delta=0.01", mesh, 1.01);
  const std::vector<Source> sources{{mesh->at_vertex(314)}};
  judge.truth(sources, random);
  judge.expect_radius(sources, 13.875089);
}

}  // namespace
}  // namespace geodrome::test
