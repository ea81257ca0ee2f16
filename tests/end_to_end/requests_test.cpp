// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/npy.hpp"

namespace {

using namespace geodrome::testing;
namespace fs = std::filesystem;

/// Requests that nobody makes on purpose.
class Requests : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "m.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 5 5\n6 6 6\n3 0 1 2\n3 0 2 3\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::vector<std::string>& arguments) { return run_geodrome(folder_, arguments); }
  /// Distances between a few vertices, with more arguments.
  Outcome distances(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"distances", file("m.off"), "--solver", "edge_dijkstra"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void expect(const Outcome& outcome, int status, const std::string& word) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    EXPECT_LT(outcome.err.size(), 400u) << "too long to be read: " << outcome.err;
  }
  bool nothing_but(const std::vector<std::string>& names) const {
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      const std::string name = entry.path().filename().string();
      if (name != "stdout" && name != "stderr" && std::find(names.begin(), names.end(), name) == names.end())
        return false;
    }
    return true;
  }

  TemporaryFolder folder_;
};

TEST_F(Requests, NumbersThatAreNoneAreUsageErrorsInShortWords) {
  for (const std::string word : {"nan", "-1", "abc", "1e400", "", "1 2"})
    expect(distances({"-o", file("d.npy"), "--max-distance", word}), 2, "--max-distance");
  expect(distances({"-o", file("d.npy"), "--audit", "nan"}), 2, "--audit");
  expect(distances({"-o", file("d.npy"), "--audit", "1.01"}), 2, "--audit");
  for (const std::string word : {"-1", "1.5", "1e3", "4294967297"})
    expect(distances({"-o", file("d.npy"), "--threads", word}), 2, "--threads");
  for (const std::string option : {"--points", "--faces", "--seed"})
    expect(run({"shape", "sphere", "-o", file("s.off"), option, "-5"}), 2, option);
  for (const std::string option : {"--points", "--faces"})
    expect(run({"shape", "sphere", "-o", file("s.off"), "--mesh", option, "99999999999999"}), 2, option);
  expect(run({"shape", "sphere", "-o", file("s.off"), "--noise", "inf"}), 2, "--noise");
  EXPECT_TRUE(nothing_but({"m.off"}));
}

TEST_F(Requests, AnInfiniteLargestDistanceIsNone) {
  ASSERT_EQ(distances({"-o", file("d.csv")}).status, 0);
  ASSERT_EQ(distances({"-o", file("e.csv"), "--max-distance", "inf"}).status, 0);
  EXPECT_EQ(read_bytes(folder_ / "d.csv"), read_bytes(folder_ / "e.csv"));
}

TEST_F(Requests, ChoicesAreWordsAlone) {
  expect(distances({"-o", file("d.npy"), "--dtype", "1"}), 2, "float32");
  ASSERT_EQ(distances({"-o", file("d.npy"), "--dtype", "float32"}).status, 0);
  EXPECT_NE(read_bytes(folder_ / "d.npy").find("<f4"), std::string::npos);
  expect(run({"shape", "sphere", "-o", file("s.xyz"), "--sampling", "2"}), 2, "blue");
}

TEST_F(Requests, AnUnknownCommandIsNamedWithTheKnownOnes) {
  expect(run({"distance", file("m.off")}), 2, "'distance'");
  expect(run({"distance", file("m.off")}), 2, "compare");
}

TEST_F(Requests, NoFileIsWrittenOverOneThatIsRead) {
  fs::copy(file("m.off"), file("m.obj.off"));
  const std::string before = read_bytes(folder_ / "m.off");
  expect(run({"surface", file("m.off"), "-o", file("m.off")}), 2, "m.off");
  fs::create_symlink(file("m.off"), file("link.off"));
  expect(run({"surface", file("m.off"), "-o", file("link.off")}), 2, "link.off");
  expect(distances({"--nearest", file("n.csv"), "--surface", file("m.off")}), 2, "m.off");
  write_bytes(folder_ / "list.csv", "0\n");
  expect(distances({"-o", file("list.csv"), "--sources", "@" + file("list.csv")}), 2, "list.csv");
  expect(run({"path", file("m.off"), "--from", "@" + file("list.csv"), "--to", "1", "-o", file("list.csv")}), 2,
         "list.csv");
  EXPECT_EQ(read_bytes(folder_ / "m.off"), before);
  EXPECT_EQ(read_bytes(folder_ / "list.csv"), "0\n");
}

TEST_F(Requests, OneFileCannotBeTwoOutputs) {
  expect(distances({"-o", file("d.csv"), "--nearest", (folder_ / "." / "d.csv").string()}), 2, "d.csv");
  EXPECT_TRUE(nothing_but({"m.off"}));
}

TEST_F(Requests, APlaceThatCannotBeWrittenIsFoundBeforeAnythingIsComputed) {
  fs::create_directory(file("d.npy"));
  expect(distances({"-o", file("d.npy")}), 3, "directory");
  fs::create_directory(file("r.json"));
  expect(distances({"-o", file("e.npy"), "--report", file("r.json")}), 3, "directory");
  fs::create_symlink("/dev/full", file("full.csv"));
  expect(distances({"--nearest", file("full.csv")}), 3, "full.csv");
  expect(run({"path", file("m.off"), "--from", "0", "--to", "1", "-o", file("no/p.csv")}), 3, "make it first");
  expect(run({"surface", file("m.off"), "-o", file("no/s.off")}), 3, "make it first");
  expect(run({"surface", file("m.off"), "-o", file("s.npy")}), 2, ".ply");
  EXPECT_TRUE(nothing_but({"m.off", "d.npy", "r.json", "full.csv"}));
}

TEST_F(Requests, ListsWithMistakesNameTheWordAndTheRemedy) {
  for (const std::string list : {"", ",", "0,,1", "0,1,", "0 1", "0 1 2", "-1", "+1", "1.5", "nan", "6", "5-6", "2-1",
                                 "0:9:9,0:x", "0-4000000000", "99999999999999999999"})
    expect(distances({"-o", file("d.npy"), "--sources", list}), 2, ";");
  expect(distances({"-o", file("d.npy"), "--sources", "@" + folder_.path().string()}), 3, "directory");
  expect(distances({"-o", file("d.npy"), "--sources", "@"}), 3, "list");
  for (const std::string line : {"0 +", "0 + -1", "0 + nan", "0 + 1 2", "1 2", "0 0.5 0.5 0.5", "nan 0 0"}) {
    write_bytes(folder_ / "l.txt", "0\n" + line + "\n");
    expect(distances({"-o", file("d.npy"), "--sources", "@" + file("l.txt")}), 3, "l.txt: line 2");
  }
  write_bytes(folder_ / "l.txt", std::string("0") + '\0' + "\n");
  expect(distances({"-o", file("d.npy"), "--sources", "@" + file("l.txt")}), 3, "'0?'");
}

TEST_F(Requests, ListsMayHaveWindowsLineEndsAndSpacesInTheirName) {
  write_bytes(folder_ / "my list.txt", "\xEF\xBB\xBF# sources\r\n0\r\n\r\n1\t+ 0.5\r\n0.5 0.5 3");
  ASSERT_EQ(distances({"-o", file("d.csv"), "--sources", "@" + file("my list.txt"), "--targets", "0,1"}).status, 0);
  EXPECT_EQ(read_bytes(folder_ / "d.csv").substr(0, 10), "0,1\n1.5,0.");
}

TEST_F(Requests, FileNamesMayHoldBytesThatAreNoText) {
  const std::string name = file("m\xFF.off");
  fs::copy(file("m.off"), name);
  EXPECT_TRUE(nlohmann::json::parse(run({"check", name, "--json"}).out)["usable"]);
  const std::vector<std::string> job{"distances", name, "-o", file("d\xFF.npy"), "--report", file("r.json")};
  ASSERT_EQ(run(job).status, 0);
  EXPECT_EQ(nlohmann::json::parse(read_bytes(folder_ / "r.json"))["input"]["rows"], 6);
}

TEST_F(Requests, PathFromAPointToItselfHasLengthZero) {
  EXPECT_NE(run({"path", file("m.off"), "--from", "1", "--to", "1", "-o", file("p.csv")}).out.find("distance 0,"),
            std::string::npos);
  EXPECT_NE(run({"path", file("m.off"), "--from", "4", "--to", "4", "-o", file("p.json")}).out.find("distance 0,"),
            std::string::npos)
      << "also where no face is";
  EXPECT_EQ(nlohmann::json::parse(read_bytes(folder_ / "p.json"))["distance"], 0.0);
  EXPECT_NE(run({"path", file("m.off"), "--from", "4", "--to", "5", "-o", file("p.csv")}).out.find("unreachable"),
            std::string::npos);
}

TEST_F(Requests, APluginFileThatIsNotThereIsUsage) {
  expect(run({"distances", file("m.off"), "-o", file("d.npy"), "--solver", file("solver_x.so")}), 2, "solver_x.so");
}

TEST_F(Requests, FindingsAreToldWithTheirNumberAndPlace) {
  ASSERT_EQ(run({"shape", "cut-sphere", "--points", "1500", "--sampling", "blue", "-o", file("c.xyz")}).status, 0);
  const Outcome surface = run({"surface", file("c.xyz"), "-o", file("c.ply")});
  EXPECT_NE(surface.err.find("1 boundary loop (the points named are on them)"), std::string::npos) << surface.err;
  EXPECT_NE(surface.err.find("boundary=open"), std::string::npos) << surface.err;
  EXPECT_NE(surface.err.find("["), std::string::npos) << surface.err;
}

TEST_F(Requests, WhatIsOnlyANoteOfAMeshIsToldByCheckAlone) {
  EXPECT_NE(run({"check", file("m.off")}).out.find("4 boundary edges in 1 loop"), std::string::npos);
  const std::string told = distances({"-o", file("d.npy")}).err;
  EXPECT_EQ(told.find("boundary"), std::string::npos) << told;
  EXPECT_NE(told.find("2 vertices are on no face: unreachable. [4, 5]"), std::string::npos) << told;
}

/// Solvers that estimate the distances of vertices.
class Estimates : public Requests, public ::testing::WithParamInterface<std::string> {
 protected:
  Outcome estimate(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"distances", file("m.off"), "--solver", GetParam()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void expect_lacks(const Outcome& outcome, const std::string& capability) {
    expect(outcome, 3, "solver_" + GetParam() + " does not provide");
    EXPECT_NE(outcome.err.find(capability), std::string::npos) << outcome.err;
  }
};

TEST_P(Estimates, AreNotCalledBrokenForWhatTheyDoNotPromise) {
  const Outcome outcome = estimate({"-o", file("d.npy"), "--report", file("r.json"), "--audit", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("no stated guarantee"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("invariants hold"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("D >= Euclid, symmetry, triangle inequality)"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("not audited"), std::string::npos) << outcome.out;
  const Matrix d = read_npy(folder_ / "d.npy");
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(d(i, i), 0);
  EXPECT_NEAR(d(0, 2), std::sqrt(2), 0.4);
  EXPECT_EQ(d(0, 4), INFINITY);
}

TEST_P(Estimates, NameTheNearestSource) {
  ASSERT_EQ(estimate({"--nearest", file("n.csv"), "--sources", "1,3"}).status, 0);
  const std::string nearest = read_bytes(folder_ / "n.csv");
  EXPECT_NE(nearest.find("\n1,0,1,reached\n"), std::string::npos) << nearest;
  EXPECT_NE(nearest.find("\n3,0,3,reached\n4,inf,,unreachable\n"), std::string::npos) << nearest;
}

TEST_P(Estimates, RefuseByNameWhatTheyCannotDo) {
  write_bytes(folder_ / "inside.txt", "0.6 0.3 0\n");
  const std::string inside = "@" + file("inside.txt");
  expect_lacks(run({"path", file("m.off"), "--from", "0", "--to", "2", "-o", file("p.csv"), "--solver", GetParam()}),
               "paths");
  expect_lacks(estimate({"-o", file("d.npy"), "--sources", "0", "--targets", inside}), "any_point");
  write_bytes(folder_ / "pairs.txt", "0 2\n");
  expect_lacks(
      run({"queries", file("m.off"), "--pairs", file("pairs.txt"), "-o", file("q.csv"), "--solver", GetParam()}),
      "pair_queries");
  EXPECT_TRUE(nothing_but({"m.off", "inside.txt", "pairs.txt"}));
}

INSTANTIATE_TEST_SUITE_P(Solvers, Estimates, ::testing::Values("fast_marching", "heat"),
                         [](const auto& info) { return info.param; });

/// What one of them can do and the other cannot.
TEST_F(Requests, LimitsAndSourcesInFacesDependOnTheSolver) {
  write_bytes(folder_ / "inside.txt", "0.6 0.3 0\n");
  write_bytes(folder_ / "late.txt", "0\n2 + 0.5\n");
  const auto with = [&](const std::string& solver, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"distances", file("m.off"), "--solver", solver};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const std::vector<std::string> within{"-o", file("d.npy"), "--max-distance", "1.2"};
  const std::vector<std::string> inside{"-o",    file("e.npy"), "--targets",
                                        "0,1,2", "--sources",   "@" + file("inside.txt")};
  const std::vector<std::string> late{"--nearest", file("n.csv"), "--sources", "@" + file("late.txt")};
  expect(with("heat", within), 3, "solver_heat does not provide a largest distance (radius_limit)");
  expect(with("heat", inside), 3, "solver_heat does not provide sources that are no vertices (face_sources)");
  expect(with("heat", late), 3, "start_distances");
  EXPECT_TRUE(nothing_but({"m.off", "inside.txt", "late.txt"}));
  ASSERT_EQ(with("fast_marching", within).status, 0);
  EXPECT_EQ(read_npy(folder_ / "d.npy")(0, 2), INFINITY);
  EXPECT_EQ(read_npy(folder_ / "d.npy")(0, 1), 1);
  ASSERT_EQ(with("fast_marching", inside).status, 0);
  EXPECT_NEAR(read_npy(folder_ / "e.npy")(0, 1), 0.5, 1e-15);
  ASSERT_EQ(with("fast_marching", late).status, 0);
  EXPECT_NE(read_bytes(folder_ / "n.csv").find("\n2,0.5,2,reached\n"), std::string::npos);
}

}  // namespace
