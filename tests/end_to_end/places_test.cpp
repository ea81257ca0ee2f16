// SPDX-License-Identifier: MIT
// Lists, points off the surface, welding and the precision of files, through the program.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;
using nlohmann::json;

class Places : public ::testing::Test {
 protected:
  void SetUp() override {
    write_bytes(folder_ / "square.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    write_bytes(folder_ / "far.txt", "1000 1000 1000\n");
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string list(const std::string& text) {
    write_bytes(folder_ / "list.txt", text);
    return "@" + file("list.txt");
  }
  Outcome run(const std::vector<std::string>& arguments) { return run_geodrome(folder_, arguments); }
  Outcome distances(const std::string& sources, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"distances", file("square.off"), "--sources", sources, "-o", file("d.csv")});
    return run(more);
  }
  std::string csv(const std::string& sources) {
    const Outcome outcome = distances(sources);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_bytes(folder_ / "d.csv");
  }
  static bool warns(const Outcome& outcome) { return outcome.err.find("warning: ") != std::string::npos; }
  static void expect_off(const Outcome& outcome, const std::string& part) {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("warning: 1 point that is named lies off the surface, "), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  }

  TemporaryFolder folder_;
};

TEST_F(Places, ListsAreRangesAndMayHaveBlanks) {
  const std::string all = csv("all");
  EXPECT_EQ(csv("0-3"), all);
  EXPECT_EQ(csv("0:4"), all);
  EXPECT_EQ(csv("0, 1, 2-3"), all);
  EXPECT_EQ(csv(list("0.000000000000000000e+00\n1.000000000000000000e+00\n2-3\n")), all);
  EXPECT_EQ(csv("0:4:3"), csv("0,3"));
}

TEST_F(Places, NegativeByRoundingIs0) {
  EXPECT_EQ(csv(list("1 -5.6e-17 0.4 0.6\n")), csv(list("1 0 0.4 0.6\n")));
  EXPECT_EQ(distances(list("1 -1e-3 0.4 0.601\n")).status, 3);
}

TEST_F(Places, OffTheSurfaceAreToldByEveryJob) {
  const std::string far = "@" + file("far.txt");
  expect_off(distances(far, {"--report", file("r.json")}), "far.txt: line 1 by 1731 (1224 times its diagonal)");
  const json told = json::parse(read_bytes(folder_ / "r.json"))["places_off_surface"];
  EXPECT_EQ(told["warned"], 1);
  EXPECT_NEAR(told["farthest"][0]["distance"], std::sqrt(2 * 999.0 * 999 + 1e6), 1e-9);
  expect_off(distances("0", {"--targets", far}), "1731");
  expect_off(run({"distances", file("square.off"), "--sources", far, "--nearest", file("n.csv")}), "1731");
  expect_off(run({"compare", file("square.off"), "--solver", "chen_han", "--sources", far, "-o", file("c.json")}),
             "1731");
  EXPECT_NEAR(json::parse(read_bytes(folder_ / "c.json"))["sources"][0]["off_surface"], 1730.9, 0.1);
  write_bytes(folder_ / "p.txt", "0, 1\n0.5 0.5 -3, 2\n");
  const Outcome pairs = run({"queries", file("square.off"), "--pairs", file("p.txt"), "-o", file("q.csv"), "--solver",
                             "aleksandrov", "--report", file("q.json")});
  expect_off(pairs, "p.txt: line 2 by 3");
  EXPECT_NE(pairs.out.find("places     1 of 1 named by coordinates is off the surface: "), std::string::npos);
  EXPECT_EQ(json::parse(read_bytes(folder_ / "q.json"))["places_off_surface"]["farthest"][0]["distance"], 3);
}

TEST_F(Places, NearTheSurfaceAreSilentAndBetweenStandInTheReport) {
  const Outcome near = distances(list("0.5 0.5 1e-6\n"), {"--report", file("r.json")});
  EXPECT_FALSE(warns(near)) << near.err;
  EXPECT_EQ(near.out.find("places"), std::string::npos);
  EXPECT_FALSE(json::parse(read_bytes(folder_ / "r.json")).contains("places_off_surface"));
  const Outcome between = distances(list("0.5 0.5 1e-3\n"), {"--report", file("r.json")});
  EXPECT_FALSE(warns(between)) << between.err;
  EXPECT_NE(between.out.find("places     1 of 1"), std::string::npos) << between.out;
  const json told = json::parse(read_bytes(folder_ / "r.json"))["places_off_surface"];
  EXPECT_EQ(told["off_surface"], 1);
  EXPECT_EQ(told["warned"], 0);
}

TEST_F(Places, ThatCouldBeRowsAreToldAsSuch) {
  const Outcome outcome = distances(list("0 1 2\n"));
  expect_off(outcome, "three whole numbers that could be rows; if rows are meant, write one a line");
}

TEST_F(Places, OfACloudAreJudgedBesideItsOwnPoints) {
  ASSERT_EQ(run({"shape", "torus", "--points", "1500", "-o", file("t.xyz")}).status, 0);
  const auto from = [&](const std::string& sources) {
    return run({"distances", file("t.xyz"), "--sources", sources, "--targets", "0", "-o", file("d.csv")});
  };
  EXPECT_EQ(from("all").err.find("off the surface"), std::string::npos) << "rows that decimation removed";
  const std::string points = read_bytes(folder_ / "t.xyz");
  EXPECT_EQ(from(list(points)).err.find("off the surface, "), std::string::npos) << "the same places by coordinates";
  expect_off(from(list("5 0 0\n")), "list.txt: line 1 by");
}

TEST_F(Places, APathGoesFromAPointOnTheCommandLine) {
  const auto path = [&](const std::string& from, const std::string& to) {
    return run({"path", file("square.off"), "--from", from, "--to", to, "-o", file("p.json")});
  };
  const Outcome inside = path("0.25,0.25,0", "1,0,1,0");
  EXPECT_EQ(inside.out.substr(0, 28), "distance 1.0606601717798212,") << inside.out << inside.err;
  EXPECT_EQ(inside.out.find("off the surface"), std::string::npos);
  EXPECT_EQ(path("0.25 0.25 0", "3").out, inside.out);
  EXPECT_FALSE(json::parse(read_bytes(folder_ / "p.json")).contains("from_off_surface"));
  const Outcome beside = path("-0.5,0.25,0", "0");
  expect_off(beside, "'-0.5 0.25 0' by 0.5");
  EXPECT_NE(beside.out.find("the start lies 0.5 off the surface"), std::string::npos) << beside.out;
  EXPECT_EQ(json::parse(read_bytes(folder_ / "p.json"))["from_off_surface"], 0.5);
  EXPECT_EQ(path("0,1", "2").status, 2);
  EXPECT_EQ(path("0-1", "2").status, 2);
}

/// A strip of squares around a cylinder of 8 sides, whose seam is there twice but for rounding.
std::string torn_ring() {
  std::string text = "OFF\n18 16 0\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i <= 8; ++i) {
      char line[96];
      std::snprintf(line, sizeof line, "%.17g %.17g %d\n", std::cos(i * M_PI / 4), std::sin(i * M_PI / 4), j);
      text += line;
    }
  for (int i = 0; i < 8; ++i) {
    const auto v = [](int k) { return " " + std::to_string(k); };
    text += "3" + v(i) + v(i + 1) + v(i + 10) + "\n3" + v(i) + v(i + 10) + v(i + 9) + "\n";
  }
  return text;
}

TEST_F(Places, ASeamIsJoinedWithTheToleranceThatTheWarningNames) {
  write_bytes(folder_ / "ring.off", torn_ring());
  const auto around = [&](const std::vector<std::string>& weld) {
    std::vector<std::string> arguments{"distances", file("ring.off"), "--sources", "1", "--targets", "7",
                                       "-o",        file("r.csv")};
    arguments.insert(arguments.end() - 6, weld.begin(), weld.end());
    return run(arguments);
  };
  const double side = 2 * std::sin(M_PI / 8);
  for (const std::vector<std::string>& weld : {std::vector<std::string>{}, {"--weld"}}) {
    const Outcome torn = around(weld);
    EXPECT_NE(torn.err.find("2 open edges lie on another one, at most 2.4"), std::string::npos) << torn.err;
    EXPECT_NE(torn.err.find("--weld 1e-15 joins them"), std::string::npos) << torn.err;
    EXPECT_NEAR(std::stod(read_bytes(folder_ / "r.csv")), 6 * side, 1e-12);
  }
  for (const std::vector<std::string>& weld : {std::vector<std::string>{"--weld", "1e-15"}, {"--weld=1e-9"}}) {
    const Outcome joined = around(weld);
    EXPECT_EQ(joined.err.find("open edges"), std::string::npos) << joined.err;
    EXPECT_NEAR(std::stod(read_bytes(folder_ / "r.csv")), 2 * side, 1e-12);
  }
}

TEST_F(Places, WeldStandsBeforeANumberOrAlone) {
  write_bytes(folder_ / "twins.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n");
  const auto check = [&](const std::vector<std::string>& arguments) { return run(arguments); };
  EXPECT_NE(check({"check", "--weld", file("twins.off")}).out.find("1 component,"), std::string::npos);
  EXPECT_NE(check({"check", file("twins.off"), "--weld"}).out.find("1 component,"), std::string::npos);
  EXPECT_NE(check({"check", "--weld", "0.1", file("twins.off")}).out.find("1 component,"), std::string::npos);
  EXPECT_NE(check({"check", file("twins.off")}).out.find("2 components,"), std::string::npos);
  for (const std::string wrong : {"-1", "nan", "inf", "1e101"})
    EXPECT_EQ(check({"check", file("twins.off"), "--weld", wrong}).status, 2) << wrong;
  const Outcome chain = check({"check", file("twins.off"), "--weld", "1.1"});
  EXPECT_EQ(chain.status, 3);
  EXPECT_NE(chain.err.find("welding within 1.1 would move vertex"), std::string::npos) << chain.err;
}

/// 5 x 5 vertices a tenth of a metre apart, far from the origin as on a map.
std::string map_off() {
  std::string text = "OFF\n25 32 0\n";
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) text += "512434." + std::to_string(i) + " 5405590." + std::to_string(j) + " 0\n";
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const auto v = [&](int di, int dj) { return " " + std::to_string(i + di + 5 * (j + dj)); };
      text += "3" + v(0, 0) + v(1, 0) + v(1, 1) + "\n3" + v(0, 0) + v(1, 1) + v(0, 1) + "\n";
    }
  return text;
}

TEST_F(Places, FilesOf32BitFloatsTellWhatFallsTogether) {
  write_bytes(folder_ / "map.off", map_off());
  const Outcome stl = run({"surface", file("map.off"), "-o", file("map.stl")});
  EXPECT_EQ(stl.status, 0) << stl.err;
  EXPECT_NE(stl.err.find("map.stl holds 32-bit floats, which move vertices by up to"), std::string::npos) << stl.err;
  EXPECT_NE(stl.err.find("write .ply, .off or .obj"), std::string::npos) << stl.err;
  const Outcome ply = run({"surface", file("map.off"), "-o", file("map.ply"), "--dtype", "float32"});
  EXPECT_NE(ply.err.find("map.ply holds 32-bit floats"), std::string::npos) << ply.err;
  EXPECT_FALSE(warns(run({"surface", file("map.off"), "-o", file("map.ply")})));
  EXPECT_EQ(run({"surface", file("map.off"), "-o", file("map.obj"), "--dtype", "float32"}).status, 2);
  const Outcome matrix = run({"distances", file("map.off"), "--sources", "0", "-o", file("d.npy"), "--surface",
                              file("used.stl"), "--report", file("r.json")});
  EXPECT_NE(matrix.err.find("used.stl holds 32-bit floats"), std::string::npos) << matrix.err;
  EXPECT_EQ(json::parse(read_bytes(folder_ / "r.json"))["surface_file"]["findings"][0]["code"], "float32_loss");
}

TEST_F(Places, ATruthWithALargestNumberForUnreachableIsRefused) {
  for (const double huge : {1.7976931348623157e308, 3.4028234663852886e38, 1e100}) {
    const double entries[] = {0, 1, 1, huge};
    std::string bytes = "\x93NUMPY\x01";
    bytes += std::string("\0v\0", 3) + "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 4), }";
    bytes.resize(127, ' ');
    bytes += "\n" + std::string(reinterpret_cast<const char*>(entries), sizeof entries);
    write_bytes(folder_ / "t.npy", bytes);
    const Outcome outcome =
        run({"compare", file("square.off"), "--solver", "chen_han", "--sources", "0", "--truth", file("t.npy")});
    EXPECT_EQ(outcome.status, 3) << outcome.err;
    EXPECT_NE(outcome.err.find("t.npy: row 0, column 3 is "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("write inf for unreachable"), std::string::npos) << outcome.err;
  }
}

}  // namespace
