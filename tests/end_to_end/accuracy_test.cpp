// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/support/npy.hpp"
#include "tests/support/program.hpp"

namespace {

using namespace geodrome::testing;

struct Point {
  double x, y, z;
};

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Points in, distances out, compared with a truth from elsewhere.
class Accuracy : public ::testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void run(const std::vector<std::string>& arguments) {
    const Outcome outcome = run_geodrome(folder_, arguments);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  std::vector<Point> points(const std::string& name) const {
    std::istringstream in(read_bytes(folder_ / name));
    std::vector<Point> all;
    for (Point p{}; in >> p.x >> p.y >> p.z;) all.push_back(p);
    return all;
  }
  /// Mean and largest relative error of the pairs whose true distance is at least a quarter of the largest.
  template <class Truth>
  std::pair<double, double> far_error(const Matrix& d, const Truth& truth) const {
    double largest = 0, sum = 0, worst = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < d.rows; ++i)
      for (std::size_t j = 0; j < d.columns; ++j) largest = std::max(largest, truth(i, j));
    for (std::size_t i = 0; i < d.rows; ++i)
      for (std::size_t j = 0; j < d.columns; ++j) {
        if (truth(i, j) < 0.25 * largest) continue;
        const double error = std::abs(d(i, j) - truth(i, j)) / truth(i, j);
        sum += error, worst = std::max(worst, error), ++count;
      }
    return {sum / static_cast<double>(count), worst};
  }

  TemporaryFolder folder_;
};

TEST_F(Accuracy, PlanePointsHaveTheStraightDistance) {
  run({"shape", "plane", "--sampling", "grid", "--points", "400", "-o", file("p.xyz")});
  run({"distances", file("p.xyz"), "--sources", "0,57,199", "-o", file("d.npy")});
  const auto p = points("p.xyz");
  const Matrix d = read_npy(folder_ / "d.npy");
  const std::size_t sources[] = {0, 57, 199};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < p.size(); ++j)
      EXPECT_NEAR(d(i, j), std::hypot(p[sources[i]].x - p[j].x, p[sources[i]].y - p[j].y), 1e-12);
}

TEST_F(Accuracy, SpherePointsApproachTheGreatCircle) {
  run({"shape", "sphere", "--points", "2000", "-o", file("s.xyz")});
  run({"distances", file("s.xyz"), "--sources", "0,1,2,3,4", "-o", file("d.npy")});
  const auto p = points("s.xyz");
  const auto truth = [&](std::size_t i, std::size_t j) { return std::acos(std::clamp(dot(p[i], p[j]), -1.0, 1.0)); };
  const auto [mean, worst] = far_error(read_npy(folder_ / "d.npy"), truth);
  EXPECT_LT(mean, 0.006);
  EXPECT_LT(worst, 0.03);
}

TEST_F(Accuracy, TorusPointsApproachTheDistancesOfAMeshTwentyTimesFiner) {
  run({"shape", "torus", "--points", "2000", "-o", file("t.xyz")});
  run({"shape", "torus", "--mesh", "--faces", "40000", "-o", file("fine.ply")});
  const auto p = points("t.xyz");
  std::string list;
  for (std::size_t i = 0; i < p.size(); ++i) {
    std::ostringstream line;
    line.precision(17);
    line << p[i].x << " " << p[i].y << " " << p[i].z << "\n";
    if (i < 2) write_bytes(folder_ / "sources.txt", list + line.str());
    list += line.str();
  }
  write_bytes(folder_ / "targets.txt", list);
  run({"distances", file("fine.ply"), "--sources", "@" + file("sources.txt"), "--targets", "@" + file("targets.txt"),
       "--audit", "0", "-o", file("truth.npy")});
  run({"distances", file("t.xyz"), "--sources", "0,1", "-o", file("d.npy")});
  const Matrix truth = read_npy(folder_ / "truth.npy");
  const auto [mean, worst] = far_error(read_npy(folder_ / "d.npy"), truth);
  EXPECT_LT(mean, 0.007);  // 3.4e-3 is typical; the fine mesh itself is within 2e-4
  EXPECT_LT(worst, 0.04);
}

}  // namespace
