// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/program.hpp"
#include "tests/support/samples.hpp"

namespace {

using namespace geodrome;
using namespace geodrome::testing;
using nlohmann::json;

/// Point clouds through `geodrome check`: the sample report.
class Check : public ::testing::Test {
 protected:
  void write(const PointSample& sample) {
    std::ostringstream text;
    text.precision(17);
    for (const Vec3& p : sample.points) text << p.x << " " << p.y << " " << p.z << "\n";
    write_bytes(folder_ / "p.xyz", text.str());
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"check", file("p.xyz")});
    return run_geodrome(folder_, arguments);
  }
  json report(std::vector<std::string> arguments = {}, int status = 0) {
    arguments.push_back("--json");
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    return json::parse(outcome.out);
  }

  TemporaryFolder folder_;
};

Vec3 position(const json& place) { return {place["position"][0], place["position"][1], place["position"][2]}; }

TEST_F(Check, TellsOfAGoodSampleThatTheSurfaceIsRight) {
  write(test::torus(3000, 5));
  const json r = report();
  EXPECT_TRUE(r["usable"]);
  EXPECT_FALSE(r["refused"]);
  EXPECT_EQ(r["surface"]["genus"], 1);
  EXPECT_EQ(r["surface"]["boundary_loops"], 0);
  EXPECT_EQ(r["sample"]["points"], 3000);
  EXPECT_EQ(r["stages"].size(), 4u);
  EXPECT_LT(r["sample"]["distance_from_surface"]["largest_over_diagonal"], 0.02);
  EXPECT_GT(r["sample"]["distance_from_surface"]["largest"], 0);
  for (const json& claim : r["guarantee_of_the_paper"]["claims"])
    if (claim["code"] != "epsilon") {
      EXPECT_EQ(claim["holds"], true) << claim;
    }
}

TEST_F(Check, AsksForMorePointsWhereTheyAreFewForTheShape) {
  write(test::torus(400, 5));
  const json r = report();
  EXPECT_GT(r["sample"]["epsilon_at_least"], 0.5);
  EXPECT_GT(r["sample"]["points_for_practice"], 400);
  EXPECT_GT(r["sample"]["points_for_the_paper"], 40'000);
  EXPECT_EQ(r["practice"]["verdict"], "doubtful");
}

TEST_F(Check, FindsThePatchThatWasThinned) {
  const Vec3 centre{1.4, 0, 0};
  PointSample sample;
  test::Random random(9);
  for (const Vec3& p : test::torus(12'000, 5).points)
    if (distance(p, centre) > 0.5 || random.uniform() < 0.03) sample.points.push_back(p);
  write(sample);
  const json worst = report()["worst_places"];
  ASSERT_FALSE(worst.empty());
  EXPECT_TRUE(worst[0]["troubles"][0]["fails"]);
  for (const json& place : worst)
    if (place["troubles"][0]["fails"]) {
      EXPECT_LT(distance(position(place), centre), 0.75) << place;
    }
}

TEST_F(Check, NamesPlacesByTheRowOfTheFile) {
  PointSample sample = test::torus(1000, 5);
  sample.points.insert(sample.points.begin(), 7, sample.points.front());  // rows 1 to 7 are merged into row 0
  write(sample);
  const json r = report();
  EXPECT_EQ(r["sample"]["merged"], 7);
  ASSERT_FALSE(r["worst_places"].empty());
  for (const json& place : r["worst_places"]) {
    const Vec3 p = sample.points[place["row"].get<std::size_t>()];
    EXPECT_EQ(p, position(place));
  }
}

TEST_F(Check, WarnsOfANoisySample) {
  write(test::with_noise(test::torus(2000, 5), 0.25, 6));
  const Outcome outcome = run({"--json"});
  const json r = json::parse(outcome.out);
  EXPECT_TRUE(outcome.status == 4 || r["practice"]["verdict"] == "doubtful") << outcome.out;
  EXPECT_FALSE(r["worst_places"].empty());
}

TEST_F(Check, RefusesOrDoubtsPointsOfNoManifold) {
  write(test::cube(500, 4));
  const Outcome outcome = run({"--json"});
  const json r = json::parse(outcome.out);
  EXPECT_EQ(r["usable"].get<bool>(), outcome.status == 0);
  EXPECT_TRUE(outcome.status == 4 || r["practice"]["verdict"] == "doubtful") << outcome.out;
}

TEST_F(Check, TellsWhyASampleIsRefusedAndWhatIsKnownUpToThere) {
  write(test::plane_lattice(20, 20));
  const json r = report({"--reconstructor", "advancing_front:boundary=closed"}, 4);
  EXPECT_FALSE(r["usable"]);
  EXPECT_TRUE(r["refused"]);
  EXPECT_EQ(r["refusal"]["plugin"], "reconstructor_advancing_front");
  EXPECT_NE(r["refusal"]["reason"].get<std::string>().find("boundary"), std::string::npos);
  EXPECT_FALSE(r["refusal"]["remedy"].get<std::string>().empty());
  EXPECT_EQ(r["stages"].size(), 4u);
  EXPECT_GT(r["sample"]["kept"], 0);
  EXPECT_EQ(r["sample"]["unbounded"], 4 * 19);
  EXPECT_EQ(r["practice"]["verdict"], "refused");
  const Outcome text = run({"--reconstructor", "advancing_front:boundary=closed"});
  EXPECT_EQ(text.status, 4);
  EXPECT_NE(text.out.find("refused    by reconstructor_advancing_front"), std::string::npos) << text.out;
}

TEST_F(Check, TellsWhatTheFirstStageRefuses) {
  write_bytes(folder_ / "p.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
  const json r = report({}, 4);
  EXPECT_EQ(r["stages"].size(), 1u);
  EXPECT_EQ(r["sample"]["points"], 5);
  EXPECT_TRUE(r["sample"]["psi_smallest"].is_null());
}

TEST_F(Check, RunsNoStageOnDemand) {
  write_bytes(folder_ / "p.xyz", "0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n");
  const json r = report({"--input-only"});
  EXPECT_TRUE(r["usable"]);
  EXPECT_FALSE(r.contains("sample"));
}

TEST_F(Check, GivesTheSameForAnyNumberOfThreads) {
  write(test::torus(800, 5));
  json one = report({"--threads", "1"}), three = report({"--threads", "3"});
  one.erase("stages"), three.erase("stages");  // they have times
  EXPECT_EQ(one, three);
}

TEST_F(Check, ARefusalInARunWritesTheReport) {
  write(test::plane_lattice(20, 20));
  const Outcome outcome = run_geodrome(folder_, {"distances", file("p.xyz"), "-o", file("d.npy"), "--report",
                                                 file("r.json"), "--reconstructor", "advancing_front:boundary=closed"});
  EXPECT_EQ(outcome.status, 4);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
  const json r = json::parse(read_bytes(folder_ / "r.json"));
  EXPECT_TRUE(r["refused"]);
  EXPECT_EQ(r["geodrome"]["seed"], 1);
  EXPECT_EQ(r["stages"].size(), 4u);
}

TEST_F(Check, ARunOnPointsPrintsTheReportInShort) {
  write(test::torus(800, 5));
  const Outcome distances = run_geodrome(folder_, {"distances", file("p.xyz"), "-o", file("d.npy"), "--sources", "0"});
  const Outcome surface = run_geodrome(folder_, {"surface", file("p.xyz"), "-o", file("s.ply")});
  for (const char* line : {"\nsample ", "\nstars ", "\ndistance ", "\npractice ", "\nguarantee "}) {
    EXPECT_NE(distances.out.find(line), std::string::npos) << line << distances.out;
    EXPECT_NE(("\n" + surface.err).find(line), std::string::npos) << line << surface.err;
  }
}

}  // namespace
