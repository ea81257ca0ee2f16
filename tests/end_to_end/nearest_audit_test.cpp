// SPDX-License-Identifier: MIT
// Every result is audited by the search that made it: solvers that are wrong with several sources alone are found.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

class NearestAudit : public ::testing::Test {
 protected:
  NearestAudit() {
    write_bytes(folder_ / "square.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
    write_bytes(folder_ / "two.txt", "1 0.8 0.1 0.1\n1 0.1 0.1 0.8\n");
    EXPECT_EQ(run_geodrome(folder_, {"shape", "bumpy", "--mesh", "--faces", "1000", "-o", file("bumpy.ply")}).status,
              0);
    write_bytes(folder_ / "crowd.txt", "7 0.2 0.3 0.5\n7 0.6 0.2 0.2\n7 0.1 0.1 0.8 + 0.1\n");
    write_bytes(folder_ / "late.txt", "0\n200 + 0.3\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome nearest(const std::string& mesh, const std::string& list, const std::string& solver,
                  const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"distances",      file(mesh),      "--sources",
                                 "@" + file(list), "--nearest",     file("n.csv"),
                                 "--solver",       solver,          "--report",
                                 file("r.json"),   "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers"};
    all.insert(all.end(), more.begin(), more.end());
    return run_geodrome(folder_, all);
  }
  json report() const { return json::parse(read_bytes(folder_ / "r.json")); }

  TemporaryFolder folder_;
};

TEST_F(NearestAudit, FindsWhatIsWrongWithSeveralSourcesAlone) {
  struct Planted {
    const char *mesh, *list, *solver;
  };
  for (const auto& [mesh, list, solver] : {Planted{"square.off", "two.txt", "faulty_several_in_a_face"},
                                           Planted{"square.off", "two.txt", "faulty_several_sources"},
                                           Planted{"bumpy.ply", "crowd.txt", "faulty_several_in_a_face"},
                                           Planted{"bumpy.ply", "crowd.txt", "faulty_several_sources"},
                                           Planted{"bumpy.ply", "late.txt", "faulty_late_starts"}})
    for (const char* share : {"1", "0.01"}) {
      const Outcome outcome = nearest(mesh, list, solver, {"--audit", share});
      EXPECT_EQ(outcome.status, 5) << mesh << " by " << solver << ", " << outcome.out;
      EXPECT_NE(outcome.err.find("broken promise: the audit failed"), std::string::npos) << outcome.err;
    }
}

TEST_F(NearestAudit, TheSearchesFromSingleSourcesAreRightThere) {
  for (const char* solver : {"faulty_several_sources", "faulty_several_in_a_face", "faulty_late_starts"}) {
    const Outcome outcome = run_geodrome(
        folder_, {"distances", file("bumpy.ply"), "--sources", "@" + file("crowd.txt"), "-o", file("d.npy"), "--solver",
                  solver, "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers", "--audit", "1"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  }
}

TEST_F(NearestAudit, PassesWhatIsRightAndSaysWhatWasDone) {
  for (const char* solver : {"cgal", "chen_han", "schreiber", "aleksandrov:delta=0.2", "faulty_none"})
    for (const auto& [mesh, list] : {std::pair("square.off", "two.txt"), std::pair("bumpy.ply", "crowd.txt"),
                                     std::pair("bumpy.ply", "late.txt")}) {
      const Outcome outcome = nearest(mesh, list, solver, {"--audit", "0.2"});
      ASSERT_EQ(outcome.status, 0) << solver << " on " << mesh << ": " << outcome.err;
      const json audit = report()["nearest"]["audit"];
      EXPECT_EQ(audit["audited"], true);
      EXPECT_GE(audit["from_sources"], 2) << solver;
      EXPECT_EQ(audit["from_targets"], 3) << solver;
      EXPECT_GE(audit["search"]["faces"], 1);
      EXPECT_LE(audit["worst"], 1e-12) << audit;
      EXPECT_NE(outcome.out.find("audit      nearest: "), std::string::npos) << outcome.out;
    }
}

TEST_F(NearestAudit, TwoSourcesInsideOneFaceAreRightByEverySolver) {
  const double a[2] = {0.1, 0.2}, b[2] = {0.1, 0.9};  // of the corners 0, 2 and 3
  for (const char* solver : {"cgal", "chen_han", "schreiber"}) {
    ASSERT_EQ(nearest("square.off", "two.txt", solver, {"--audit", "1"}).status, 0) << solver;
    std::istringstream lines(read_bytes(folder_ / "n.csv"));
    std::string line;
    std::getline(lines, line);
    const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const auto& corner : corners) {
      ASSERT_TRUE(std::getline(lines, line));
      const double given = std::stod(line.substr(line.find(',') + 1));
      const double to_a = std::hypot(corner[0] - a[0], corner[1] - a[1]),
                   to_b = std::hypot(corner[0] - b[0], corner[1] - b[1]);
      EXPECT_NEAR(given, std::min(to_a, to_b), 1e-15) << solver << ": " << line;
    }
  }
}

TEST_F(NearestAudit, WithALimitIsAuditedToo) {
  for (const char* limit : {"0", "0.3", "1"}) {
    EXPECT_EQ(nearest("bumpy.ply", "crowd.txt", "chen_han", {"--max-distance", limit}).status, 0) << limit;
    EXPECT_EQ(report()["nearest"]["audit"]["missed"], 0);
  }
  EXPECT_EQ(nearest("bumpy.ply", "crowd.txt", "faulty_several_sources", {"--max-distance", "1"}).status, 5);
}

TEST_F(NearestAudit, OfACloudIsAuditedToo) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "torus", "--points", "600", "-o", file("t.xyz")}).status, 0);
  write_bytes(folder_ / "rows.txt", "0\n5 + 0.1\n300\n");
  EXPECT_EQ(nearest("t.xyz", "rows.txt", "chen_han", {"--audit", "1"}).status, 0);
  EXPECT_EQ(nearest("t.xyz", "rows.txt", "faulty_several_sources", {"--audit", "1"}).status, 5);
}

TEST_F(NearestAudit, RowsOfAMatrixAreHeldAgainstTheSearchesThatAreAudited) {
  const auto row = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"distances", file("bumpy.ply"), "--sources",
                                 "3",         "--plugin-path",   GEODROME_BINARY_DIR "/tests/faulty_solvers",
                                 "--report",  file("r.json")};
    all.insert(all.end(), more.begin(), more.end());
    return run_geodrome(folder_, all);
  };
  const Outcome outcome = row({"-o", file("d.npy"), "--solver", "faulty_kept_targets"});
  EXPECT_EQ(outcome.status, 5) << outcome.out;
  EXPECT_NE(outcome.err.find("the audit failed: target 641 is given "), std::string::npos) << outcome.err;
  EXPECT_GT(report()["audit"]["worst_row"], 1e-3);
  for (const std::vector<std::string>& more : {std::vector<std::string>{"-o", file("d.npy")},
                                               {"-o", file("f.npy"), "--dtype", "float32"},
                                               {"-o", file("l.npy"), "--max-distance", "0.8"}}) {
    EXPECT_EQ(row(more).status, 0);
    EXPECT_LE(report()["audit"]["worst_row"], 1e-15);
  }
}

/// One source on a mesh of which the default audit repeats the search on a small part.
TEST_F(NearestAudit, OfALargeMeshFindsFaultsFarFromTheSourceToo) {
  ASSERT_EQ(run_geodrome(folder_, {"shape", "bumpy", "--mesh", "--faces", "20000", "-o", file("large.ply")}).status, 0);
  const auto audited = [&](const std::string& solver, const std::vector<std::string>& more) {
    std::vector<std::string> all{"distances",     file("large.ply"),
                                 "--sources",     "5",
                                 "--solver",      solver,
                                 "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers",
                                 "--report",      file("r.json")};
    all.insert(all.end(), more.begin(), more.end());
    return run_geodrome(folder_, all);
  };
  const std::vector<std::string> matrix{"-o", file("d.npy")}, nearest{"--nearest", file("n.csv")},
      few{"-o", file("d.npy"), "--targets", "7000,8000,10241"};
  for (const auto& outputs : {matrix, nearest, few}) {
    EXPECT_EQ(audited("faulty_none", outputs).status, 0);
    const json audit = report()["audit"];
    EXPECT_EQ((outputs == nearest ? audit["search"] : audit)["faces"], 205) << "a hundredth of 20480";
    const Outcome outcome = audited("faulty_some_faces:error=1e-5,share=0.001", outputs);
    EXPECT_EQ(outcome.status, 5) << outcome.out;
    EXPECT_NE(outcome.err.find("the audit failed"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(audited("faulty_kept_targets", few).status, 5) << "only one far target is wrong";
  EXPECT_EQ(audited("faulty_short_paths", few).status, 5);
  EXPECT_EQ(audited("faulty_guesses_in_faces", few).status, 5);
}

TEST_F(NearestAudit, LooksAtEverySearchOfAMatrix) {
  const auto rows = [&](const std::string& threads) {
    return run_geodrome(folder_, {"distances", file("bumpy.ply"), "-o", file("d.npy"), "--sources", "0:100:10",
                                  "--threads", threads, "--report", file("r.json"), "--solver", "faulty_none",
                                  "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers"});
  };
  std::set<std::string> where;
  for (const char* threads : {"1", "2", "3"}) {
    ASSERT_EQ(rows(threads).status, 0);
    where.insert(report()["audit"]["where_row"]);
    EXPECT_EQ(report()["audit"]["searches"], 10);
    EXPECT_EQ(report()["audit"]["sources"], json({"0", "50", "90"}));
    EXPECT_EQ(report()["audit"]["from_targets"], 3);
  }
  EXPECT_EQ(where.size(), 1u) << "it does not depend on the threads";
}

TEST_F(NearestAudit, WhatNoGuaranteeCoversIsSaidNotToBeAudited) {
  ASSERT_EQ(nearest("bumpy.ply", "late.txt", "fast_marching").status, 0);
  EXPECT_EQ(report()["nearest"]["audit"]["audited"], false);
  EXPECT_NE(report()["audit"]["because"].get<std::string>().find("any_point"), std::string::npos);
}

TEST_F(NearestAudit, ReachedAtInfinityIsABrokenPromise) {
  const Outcome outcome = run_geodrome(
      folder_, {"distances", file("square.off"), "--sources", "0,1", "--nearest", file("n.csv"), "--solver",
                "bad_reaches_infinity", "--plugin-path", GEODROME_BINARY_DIR "/tests/bad_plugins"});
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.err.find("solver_bad_reaches_infinity: said reached of target 0, whose distance it gives as inf"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(file("n.csv")));
}

TEST_F(NearestAudit, APathOfAnotherLengthThanItsDistanceIsABrokenPromise) {
  const auto path = [&](const std::string& solver) {
    return run_geodrome(folder_, {"path", file("bumpy.ply"), "--from", "0", "--to", "200", "-o", file("p.obj"),
                                  "--solver", solver, "--plugin-path", GEODROME_BINARY_DIR "/tests/faulty_solvers"});
  };
  EXPECT_EQ(path("faulty_none").status, 0);
  const Outcome outcome = path("faulty_short_paths");
  EXPECT_EQ(outcome.status, 5);
  EXPECT_NE(outcome.err.find("broken promise: the path's length is "), std::string::npos) << outcome.err;
  EXPECT_EQ(path("faulty_a_millionth").status, 5) << "the path is shorter than the distance";
}

}  // namespace
