// SPDX-License-Identifier: MIT
// Distances on the smooth surface of a sample, as a user asks for them.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/matrix_file.hpp"
#include "tests/support/npy.hpp"

namespace {

using namespace geodrome;
using namespace geodrome::testing;
using nlohmann::json;

/// With `test_sphere`, which knows the unit sphere.
const std::string spheres = std::string(GEODROME_BINARY_DIR) + "/tests/sound_plugins";

class SmoothDistances : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::vector<std::string>& arguments) { return run_geodrome(folder_, arguments); }
  void make(const std::string& shape, const std::string& points) {
    ASSERT_EQ(run({"shape", shape, "--points", points, "-o", file("s.xyz")}).status, 0);
  }
  /// The mean relative error of distances between points of the unit sphere at least 0.7 apart.
  double error(const std::vector<Index>& sources) {
    const std::vector<Vec3> p = read_input(file("s.xyz"), {}).positions;
    const Matrix d = read_npy(folder_ / "d.npy");
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < d.rows; ++i)
      for (std::size_t j = 0; j < d.columns; ++j) {
        const Vec3 &s = p[sources[i]], &t = p[j];
        const double truth = std::atan2(norm(cross(s, t)), dot(s, t));
        if (truth > 0.7) sum += std::abs(d(i, j) / truth - 1), ++count;
      }
    return sum / count;
  }

  TemporaryFolder folder_;
};

TEST_F(SmoothDistances, OfASphereAreAThousandTimesAsAccurate) {
  make("sphere", "2000");
  ASSERT_EQ(run({"distances", file("s.xyz"), "-o", file("d.npy"), "--sources", "0,1,2"}).status, 0);
  const double flat = error({0, 1, 2});
  const Outcome smooth =
      run({"distances", file("s.xyz"), "-o", file("d.npy"), "--sources", "0,1,2", "--metric", "smooth", "--tangent",
           "test_sphere", "--plugin-path", spheres, "--report", file("r.json")});
  ASSERT_EQ(smooth.status, 0) << smooth.err;
  EXPECT_LT(error({0, 1, 2}), 1e-3 * flat);
  EXPECT_NE(smooth.out.find("\nsmooth     100 % of the length, by tangent_test_sphere"), std::string::npos)
      << smooth.out;
  EXPECT_EQ(json::parse(read_bytes(folder_ / "r.json"))["geodrome"]["metric"], "smooth");
}

TEST_F(SmoothDistances, HavePathsThatLieOnTheSurface) {
  make("sphere", "1000");
  const Outcome path = run({"path", file("s.xyz"), "--from", "0", "--to", "7", "--metric", "smooth", "--tangent",
                            "test_sphere", "--plugin-path", spheres, "-o", file("p.json")});
  ASSERT_EQ(path.status, 0) << path.err;
  const json found = json::parse(read_bytes(folder_ / "p.json"));
  for (const auto& point : found["points"]) {
    const auto p = point["position"].get<std::vector<double>>();
    EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 1e-4);
  }
}

TEST_F(SmoothDistances, HaveTheirFlatPathsBesideThem) {
  make("sphere", "1000");
  const Outcome path = run({"path", file("s.xyz"), "--from", "0", "--to", "7", "--metric", "smooth", "--tangent",
                            "test_sphere", "--plugin-path", spheres, "-o", file("p.csv"), "--flat", file("f.json")});
  ASSERT_EQ(path.status, 0) << path.err;
  const json flat = json::parse(read_bytes(folder_ / "f.json"));
  EXPECT_NE(path.out.find("\non the triangles: path of " + std::to_string(flat["points"].size()) + " points, length "),
            std::string::npos)
      << path.out;
  const Outcome refused =
      run({"path", file("s.xyz"), "--from", "0", "--to", "7", "-o", file("p.csv"), "--flat", file("f.json")});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("leave --flat out, or say --metric smooth"), std::string::npos) << refused.err;
}

TEST_F(SmoothDistances, OfPairsNeedNoOracle) {
  make("sphere", "500");
  write_bytes(folder_ / "pairs.txt", "0, 3\n0, 9\n");
  std::vector<std::string> words{"queries",   file("s.xyz"), "--pairs",       file("pairs.txt"),
                                 "-o",        file("q.csv"), "--metric",      "smooth",
                                 "--tangent", "test_sphere", "--plugin-path", spheres};
  const Outcome pairs = run(words);
  ASSERT_EQ(pairs.status, 0) << pairs.err;
  EXPECT_NE(pairs.out.find(", 1 search; "), std::string::npos) << pairs.out;
  words.insert(words.end(), {"--index", file("i")});
  const Outcome refused = run(words);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("leave --index out, or say --metric flat"), std::string::npos) << refused.err;
}

TEST_F(SmoothDistances, AreComparedBesideFlatOnes) {
  make("sphere", "600");
  const std::vector<Vec3> p = read_input(file("s.xyz"), {}).positions;
  std::vector<double> truth;
  for (const Vec3& t : p) truth.push_back(std::atan2(norm(cross(p[5], t)), dot(p[5], t)));
  MatrixFile written = MatrixFile::open({.out = folder_ / "t.npy", .rows = 1, .columns = truth.size()}, false);
  written.write(0, truth);
  written.finish();
  const auto compare = [&](const std::string& by, std::vector<std::string> more) {
    std::vector<std::string> all{"compare",       file("s.xyz"), "--stage",  "solver=chen_han,schreiber,heat",
                                 "--sources",     "5",           "--metric", "smooth",
                                 "--tangent",     "test_sphere", "--truth",  by,
                                 "--plugin-path", spheres};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  const json against_truth = json::parse(compare(file("t.npy"), {"--json"}).out)["combinations"];
  for (const int solver : {0, 1}) {
    const json& flat = against_truth[solver];
    EXPECT_GT(flat["errors"]["far"]["mean"], 5e-4);
    EXPECT_LT(flat["smooth"]["errors"]["far"]["mean"], 0.01 * flat["errors"]["far"]["mean"].get<double>());
    EXPECT_EQ(flat["smooth"]["paths"], p.size() - 1);
    EXPECT_EQ(flat["guarantee"]["held"], nullptr) << "the truth is not of the triangles";
  }
  EXPECT_NE(against_truth[2]["error"]["text"].get<std::string>().find("paths"), std::string::npos);
  for (const std::string truth_is : {"first", "exact:schreiber"}) {
    const json of_each_other = json::parse(compare(truth_is, {"--json"}).out)["combinations"];
    for (const int solver : {0, 1}) EXPECT_LT(of_each_other[solver]["smooth"]["errors"]["quantiles"]["0.9"], 1e-9);
  }
  const Outcome table = compare("first", {"--growth", "1"});
  EXPECT_EQ(table.status, 3) << "heat has no paths";
  EXPECT_NE(table.out.find("\n  smooth "), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("smooth: D on the smooth surface"), std::string::npos) << table.out;
}

TEST_F(SmoothDistances, AreRefusedInTheWordsOfTheProgram) {
  make("sphere", "300");
  const auto refused = [&](std::vector<std::string> more, int status, const std::string& words) {
    std::vector<std::string> all{"distances", file("s.xyz"),   "-o",   file("d.npy"), "--metric",
                                 "smooth",    "--plugin-path", spheres};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
  };
  refused({"--tangent", "pca"}, 3, "choose a --tangent estimator that does, as jet, or say --metric flat");
  refused({"--tangent", "test_sphere", "--query", "insert"}, 2, "leave --query out");
  refused({"--tangent", "test_sphere", "--bounds", file("b.npy")}, 2, "say --metric flat");
  refused({"--tangent", "test_sphere", "--solver", "heat"}, 3, "paths");
}

}  // namespace
