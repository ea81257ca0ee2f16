// SPDX-License-Identifier: MIT
// The plugins that stand beside the defaults, through the program.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

class Rivals : public ::testing::Test {
 protected:
  void shape(const std::string& kind, const std::string& points) {
    ASSERT_EQ(run({"shape", kind, "--points", points, "-o", file("p.xyz")}).status, 0);
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::vector<std::string>& arguments) const { return run_geodrome(folder_, arguments); }

  TemporaryFolder folder_;
};

TEST_F(Rivals, ASurfaceOfStarsOfASphereWithConstantPsi) {
  shape("sphere", "2000");
  const std::vector<std::string> stages{"--control", "constant", "--reconstructor", "stars"};
  std::vector<std::string> surface{"surface", file("p.xyz"), "-o", file("s.ply")};
  surface.insert(surface.end(), stages.begin(), stages.end());
  const Outcome made = run(surface);
  EXPECT_EQ(made.status, 0) << made.err;
  const json mesh = json::parse(run({"check", file("s.ply"), "--json"}).out);
  EXPECT_EQ(mesh["input"]["genus"], 0);
  EXPECT_EQ(mesh["input"]["boundary_edges"], 0);

  std::vector<std::string> check{"check", file("p.xyz"), "--json"};
  check.insert(check.end(), stages.begin(), stages.end());
  const Outcome checked = run(check);
  EXPECT_EQ(checked.status, 0) << checked.err;
  const json report = json::parse(checked.out);
  EXPECT_EQ(report["surface"]["euler_number"], 2);
  EXPECT_EQ(report["sample"]["psi_smallest"], report["sample"]["psi_largest"]);
  EXPECT_EQ(report["sample"]["inconsistent_stars"], 0);
}

TEST_F(Rivals, StarsOfATorusAreRefusedWithTheWorstPlaces) {
  shape("torus", "2000");
  const Outcome surface = run({"surface", file("p.xyz"), "-o", file("s.ply"), "--reconstructor", "stars"});
  EXPECT_EQ(surface.status, 4);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "s.ply"));
  EXPECT_NE(surface.err.find("reconstructor_stars: the union of the planar stars is no surface"), std::string::npos)
      << surface.err;

  const Outcome check = run({"check", file("p.xyz"), "--json", "--reconstructor", "stars"});
  EXPECT_EQ(check.status, 4);
  const json report = json::parse(check.out);
  EXPECT_TRUE(report["refused"]);
  EXPECT_EQ(report["refusal"]["plugin"], "reconstructor_stars");
  ASSERT_FALSE(report["worst_places"].empty());
  EXPECT_EQ(report["worst_places"][0]["troubles"][0]["code"], "crowded_edges");
}

TEST_F(Rivals, KeepTheContractOfTheirStages) {
  for (const auto& [plugin, verdict] : {std::pair("constant", "control_constant: 5 held, 0 failed, 0 not applicable"),
                                        std::pair("stars", "held    reconstructor.sphere ")}) {
    const Outcome outcome = run({"plugins", "check", plugin});
    EXPECT_EQ(outcome.status, 0) << outcome.out;
    EXPECT_NE(outcome.out.find(verdict), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find(" 0 failed"), std::string::npos) << outcome.out;
  }
}

TEST_F(Rivals, AGivenConstantPsiDecidesHowManyPointsAreKept) {
  shape("torus", "3000");
  const auto kept = [&](const std::string& control) {
    const json report = json::parse(run({"check", file("p.xyz"), "--json", "--control", control}).out);
    EXPECT_EQ(report["surface"]["genus"], 1) << control;
    return report["sample"]["kept"].get<int>();
  };
  const int fine = kept("constant:value=0.08"), coarse = kept("constant:value=0.16");
  EXPECT_GT(fine, 2 * coarse);
}

}  // namespace
