// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/audit_figures.hpp"

#include <gtest/gtest.h>

#include "geodrome/engine/input.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/bench/solvers/own_process.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

/// Jobs on a mesh of which the default audit repeats the search on a part.
class AuditFigures : public ::testing::Test {
 protected:
  AuditFigures() {
    const SurfaceMesh mesh = shapes::mesh("bumpy", 5000, 1);
    write_mesh(jobs_.mesh, mesh);
    vertices_ = mesh.vertex_count();
  }
  AuditPower power(const std::string& solver, std::size_t sources, bool nearest) {
    jobs_.solver = solver;
    return audit_power(jobs_, vertices_, sources, nearest, 3);
  }

  geodrome::testing::TemporaryFolder folder_;
  AuditJobs jobs_{.mesh = folder_ / "mesh.ply",
                  .folder = folder_.path(),
                  .plugin_path = {GEODROME_BINARY_DIR "/tests/faulty_solvers"}};
  std::size_t vertices_ = 0;
};

TEST_F(AuditFigures, EverySeedFindsWhatIsWrongOnOneFaceInAHundred) {
  for (const bool nearest : {false, true})
    for (const std::size_t sources : {1, 4}) {
      EXPECT_EQ(power("faulty_some_faces:error=1e-5,share=0.01", sources, nearest).found, 3u);
      EXPECT_EQ(power("faulty_none", sources, nearest).found, 0u);
    }
}

TEST_F(AuditFigures, TellWhatOtherChecksFindAlone) {
  const AuditPower millionth = power("faulty_a_millionth", 1, false);
  EXPECT_EQ(millionth.found, 3u);
  EXPECT_EQ(millionth.found_without, 0u);
  EXPECT_EQ(power("faulty_some_faces:error=-0.9,share=0.1", 1, false).found_without, 3u) << "below the straight line";
}

TEST_F(AuditFigures, CostOfAJobIsThatOfItsProcess) {
  const AuditCost cost = audit_cost(jobs_, "0", false, 1);
  EXPECT_GT(cost.seconds, 0);
  EXPECT_GT(cost.audited_seconds, 0);
  EXPECT_GT(cost.bytes, 1e6);
  jobs_.solver = "faulty_none:no_option=1";
  EXPECT_THROW(audit_cost(jobs_, "0", false, 1), RefusedError);
}

TEST(ProcessCost, IsOfTheChildAlone) {
  const ProcessCost idle = in_a_process_of_its_own([] {});
  const ProcessCost busy = in_a_process_of_its_own([] {
    std::vector<char> block(200'000'000, 1);
    ASSERT_EQ(block.back(), 1);
  });
  EXPECT_TRUE(idle.well && busy.well);
  EXPECT_GT(busy.peak_bytes, idle.peak_bytes + 150'000'000);
  EXPECT_FALSE(in_a_process_of_its_own([] { throw RefusedError("on purpose"); }).well);
}

}  // namespace
}  // namespace geodrome::bench
