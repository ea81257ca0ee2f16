// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

class Commands : public ::testing::Test {
 protected:
  Outcome run(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_geodrome(folder_, arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// The surface of the cube [-1, 1]^3, whose distances follow from unfolding.
  void write_cube() {
    write_bytes(folder_ / "cube.off",
                "OFF\n8 6 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
                "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  }

  TemporaryFolder folder_;
};

TEST_F(Commands, PathOverTheCubeHasTheLengthOfTheUnfoldedOne) {
  write_cube();
  run({"path", file("cube.off"), "--from", "0", "--to", "6", "-o", file("p.json")});
  const json path = json::parse(read_bytes(folder_ / "p.json"));
  EXPECT_NEAR(path["distance"].get<double>(), std::hypot(2.0, 4.0), 1e-12);
  EXPECT_NEAR(path["length"].get<double>(), std::hypot(2.0, 4.0), 1e-12);
  EXPECT_EQ(path["points"].front()["position"], json({-1.0, -1.0, -1.0}));
  EXPECT_EQ(path["points"].back()["position"], json({1.0, 1.0, 1.0}));
}

TEST_F(Commands, PathIsWrittenAsPolylineAndAsTable) {
  write_cube();
  run({"path", file("cube.off"), "--from", "0", "--to", "6", "-o", file("p.obj")});
  run({"path", file("cube.off"), "--from", "0", "--to", "6", "-o", file("p.csv")});
  EXPECT_EQ(read_bytes(folder_ / "p.obj").substr(0, 10), "v -1 -1 -1");
  EXPECT_EQ(read_bytes(folder_ / "p.csv").substr(0, 19), "x,y,z,face,b0,b1,b2");
}

TEST_F(Commands, SurfaceOfATorusSampleIsClosedOfGenusOne) {
  run({"shape", "torus", "--points", "2000", "--seed", "3", "-o", file("t.xyz")});
  run({"surface", file("t.xyz"), "-o", file("t.ply")});
  const json check = json::parse(run({"check", file("t.ply"), "--json"}).out);
  EXPECT_TRUE(check["usable"]);
  EXPECT_EQ(check["input"]["genus"], 1);
  EXPECT_EQ(check["input"]["boundary_edges"], 0);
}

TEST_F(Commands, CheckTellsOfAFileThatCannotBeUsed) {
  write_bytes(folder_ / "bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  const Outcome outcome = run_geodrome(folder_, {"check", file("bad.off"), "--json"});
  EXPECT_EQ(outcome.status, 3);
  const json check = json::parse(outcome.out);
  EXPECT_FALSE(check["usable"]);
  EXPECT_EQ(check["error"]["fault"], "index");
}

TEST_F(Commands, PluginsListAndShowNameEveryStage) {
  const json listing = json::parse(run({"plugins", "list", "--json"}).out);
  std::vector<std::string> names;
  for (const json& plugin : listing["usable"])
    names.push_back(plugin["stage"].get<std::string>() + "_" + plugin["name"].get<std::string>());
  for (const char* name :
       {"tangent_jet", "tangent_pca", "tangent_pole", "control_constant", "control_lipschitz", "decimator_greedy",
        "decimator_none", "reconstructor_advancing_front", "reconstructor_delaunay_cut", "reconstructor_stars",
        "solver_cgal", "solver_chen_han", "solver_edge_dijkstra", "solver_fast_marching", "solver_heat"})
    EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  EXPECT_TRUE(listing["refused"].empty());
  EXPECT_NE(run({"plugins", "show", "solver_cgal"}).out.find("GPL-3.0-or-later"), std::string::npos);
}

}  // namespace
