// SPDX-License-Identifier: MIT
// Raw scans through the program: refused with the part that makes a surface, which `--part largest` gives.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geodrome/engine/input.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/scans.hpp"

namespace {

using namespace geodrome;
using namespace geodrome::testing;
using nlohmann::json;

const std::filesystem::path scans = std::filesystem::path(GEODROME_SHARED_DATA) / "meshes";

class PartsOfScans : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  Outcome run(const std::string& command, const std::string& input, std::vector<std::string> options) {
    options.insert(options.begin(), {command, input});
    return run_geodrome(folder_, options);
  }
  /// Refused as a whole, with the part told; given with `--part largest`, at least this share of it.
  void expect_part(const std::string& name, double share) {
    if (!std::filesystem::exists(scans / name)) GTEST_SKIP() << scans / name << " is not there";
    const std::string scan = (scans / name).string();
    const Outcome refused = run("distances", scan, {"--sources", "0", "-o", file("d.npy"), "-q"});
    EXPECT_EQ(refused.status, 4) << refused.err;
    ASSERT_NE(refused.err.find("; --part largest gives the part that makes a surface by itself, "), std::string::npos);
    const std::string row = std::to_string(std::stoul(refused.err.substr(refused.err.find("around row ") + 11)));
    const Outcome given = run("distances", scan,
                              {"--part", "largest", "--sources", row, "-o", file("d.npy"), "--report", file("r.json")});
    ASSERT_EQ(given.status, 0) << given.err;
    const json report = json::parse(read_bytes(folder_ / "r.json"));
    EXPECT_GE(report["part"]["share"], share);
    EXPECT_NE(report["practice"]["verdict"], "doubtful");
    EXPECT_EQ(report["surface"]["components"], 1);
    const std::size_t points = report["part"]["points"];
    EXPECT_NE(given.out.find("\npart       " + std::to_string(points) + " of "), std::string::npos) << given.out;
    const Matrix matrix = read_npy(folder_ / "d.npy");
    EXPECT_EQ(std::ranges::count_if(matrix.values, [](double d) { return std::isfinite(d); }),
              static_cast<std::ptrdiff_t>(points));
    EXPECT_FALSE(std::ranges::any_of(matrix.values, [](double d) { return std::isinf(d); }));
  }

  TemporaryFolder folder_;
};

TEST_F(PartsOfScans, OfADepthCameraAreGiven) { expect_part("kinect_room.ply", 0.05); }

TEST_F(PartsOfScans, OfAnAirborneLidarAreGiven) { expect_part("lidar_autzen.ply", 0.5); }

TEST_F(PartsOfScans, AreNamedInTheWordsOfTheProgram) {
  PointSample sample = test::sphere(800, 1);
  for (const Vec3& p : test::cube(800, 2).points) sample.points.push_back(p * 2 + Vec3{2, 0, 0});
  write_points(folder_ / "s.ply", sample.points);
  const Outcome refused = run("surface", file("s.ply"), {"-o", file("m.ply")});
  EXPECT_EQ(refused.status, 4);
  EXPECT_EQ(refused.err.find('`'), std::string::npos) << refused.err;
  const Outcome checked = run("check", file("s.ply"), {});
  EXPECT_EQ(checked.status, 4);
  EXPECT_EQ(checked.out.find('`'), std::string::npos) << checked.out;
  EXPECT_NE(checked.out.find("--part largest gives the part"), std::string::npos);
  EXPECT_EQ(run("surface", file("s.ply"), {"--part", "largest", "-o", file("m.ply")}).status, 0);
  const Outcome path =
      run("path", file("s.ply"), {"--part", "largest", "--from", "0", "--to", "900", "-o", file("p.obj")});
  EXPECT_EQ(path.status, 3);
  EXPECT_NE(path.err.find("the end of the path: row 900 at ("), std::string::npos) << path.err;
  const Outcome mesh = run("distances", file("m.ply"), {"--part", "largest", "-o", file("d.npy")});
  EXPECT_EQ(mesh.status, 2);
  EXPECT_NE(mesh.err.find("; leave --part out, or take the vertices as points with --as points\n"), std::string::npos);
}

}  // namespace
