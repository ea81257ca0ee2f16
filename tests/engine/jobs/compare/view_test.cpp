// SPDX-License-Identifier: MIT
// The page of a comparison as a job writes it, with a template of the test's own.
#include "engine/jobs/compare/view.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "geodrome/engine/jobs.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(TargetsOfPaths, AreTheFarthestReachedAndDifferentOthers) {
  const std::vector<double> row{0, 3, inf, 7, nan, 7, 1, 2};
  const std::vector<std::size_t> targets = targets_of_paths(row, 4, 1);
  ASSERT_EQ(targets.size(), 4u);
  EXPECT_EQ(targets[0], 3u) << "the lower one in a tie";
  EXPECT_EQ(std::set(targets.begin(), targets.end()).size(), 4u);
  for (const std::size_t j : targets) EXPECT_TRUE(std::isfinite(row[j]) && row[j] > 0);
  EXPECT_EQ(targets, targets_of_paths(row, 4, 1));
  EXPECT_EQ(targets_of_paths(row, 99, 1).size(), 5u);
  EXPECT_TRUE(targets_of_paths(row, 0, 1).empty());
  EXPECT_TRUE(targets_of_paths({0, inf, nan}, 4, 1).empty());
}

/// Decodes base64, by its definition.
std::string bytes_of(const std::string& base64) {
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t buffer = 0;
  int bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    buffer = buffer << 6 | static_cast<std::uint32_t>(digits.find(c));
    if ((bits += 6) >= 8) bytes += static_cast<char>(buffer >> (bits -= 8) & 0xff);
  }
  return bytes;
}

template <class Number>
std::vector<Number> array_of(const Json& base64) {
  const std::string bytes = bytes_of(base64.get<std::string>());
  std::vector<Number> values(bytes.size() / sizeof(Number));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

class ComparisonViews : public ::testing::Test {
 protected:
  ComparisonViews() {
    // Two squares apart and a vertex on no face.
    write_bytes(folder_ / "two.off",
                "OFF\n9 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n9 9 9\n"
                "3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n");
    write_bytes(folder_ / "t.html", "<html><!--geodrome-comparison--></html>");
    job_.input = folder_ / "two.off";
    job_.page = folder_ / "p.html";
    job_.page_template = folder_ / "t.html";
  }
  Json data() {
    Observer quiet;
    run_compare(job_, quiet);
    const std::string page = read_bytes(job_.page);
    const std::size_t begin = page.find('{'), end = page.rfind("</script>");
    return Json::parse(page.substr(begin, end - begin));
  }

  TemporaryFolder folder_;
  CompareJob job_;
};

TEST_F(ComparisonViews, HoldSurfaceDistancesAndErrors) {
  job_.varied = {"solver=chen_han,no_such,edge_dijkstra"};
  job_.sources = "1,8";
  const Json all = data(), view = all["view"];
  EXPECT_EQ(all["schema"], "geodrome-comparison/1");
  ASSERT_EQ(view["surfaces"].size(), 1u) << "both solvers work on the same";
  EXPECT_EQ(array_of<float>(view["surfaces"][0]["positions"]).size(), 27u);
  EXPECT_EQ(array_of<std::uint32_t>(view["surfaces"][0]["triangles"]),
            (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
  ASSERT_EQ(view["combinations"].size(), 3u);
  EXPECT_TRUE(view["combinations"][1].is_null());
  const Json &exact = view["combinations"][0]["sources"], &edges = view["combinations"][2]["sources"];
  ASSERT_EQ(exact.size(), 2u);
  const auto d = array_of<float>(exact[0]["distances"]), e = array_of<float>(edges[0]["errors"]);
  ASSERT_EQ(d.size(), 9u);
  EXPECT_EQ(d[1], 0);
  EXPECT_FLOAT_EQ(d[3], std::sqrt(2.0f));
  EXPECT_TRUE(std::isinf(d[4]) && std::isinf(d[8]));
  EXPECT_FLOAT_EQ(e[3], 2 / std::sqrt(2.0f) - 1) << "along the edges of the square";
  EXPECT_EQ(e[0], 0);
  EXPECT_TRUE(std::isnan(e[1]) && std::isnan(e[4]));
  const auto alone = array_of<float>(exact[1]["distances"]);
  EXPECT_TRUE(std::isinf(alone[0]));
  EXPECT_EQ(alone[8], 0);
  EXPECT_TRUE(exact[1]["paths"].empty());
}

TEST_F(ComparisonViews, HoldPathsToTheFarthestTargetAndOthers) {
  job_.sources = "1";
  job_.paths = 2;
  const Json paths = data()["view"]["combinations"][0]["sources"][0]["paths"];
  ASSERT_EQ(paths.size(), 2u);
  EXPECT_EQ(paths[0]["target"], 3);
  EXPECT_DOUBLE_EQ(paths[0]["distance"], std::sqrt(2.0));
  EXPECT_NEAR(paths[0]["length"].get<double>(), std::sqrt(2.0), 1e-14);
  const auto points = array_of<float>(paths[0]["points"]);
  ASSERT_GE(points.size(), 6u);
  EXPECT_EQ(std::vector<float>(points.begin(), points.begin() + 3), (std::vector<float>{1, 0, 0}));
  EXPECT_EQ(std::vector<float>(points.end() - 3, points.end()), (std::vector<float>{0, 1, 0}));
}

TEST_F(ComparisonViews, OfASampleHoldErrorsAtTheVerticesThatAreItsPoints) {
  std::string grid;
  for (int i = 0; i < 100; ++i) grid += std::to_string(i / 10) + " " + std::to_string(i % 10) + " 0\n";
  write_bytes(folder_ / "grid.xyz", grid);
  job_.input = folder_ / "grid.xyz";
  job_.varied = {"decimator=none,greedy", "solver=chen_han"};
  const Json view = data()["view"];
  ASSERT_EQ(view["combinations"].size(), 2u);
  ASSERT_EQ(view["surfaces"].size(), 2u);
  EXPECT_EQ(view["combinations"][1]["surface"], 1);
  const auto errors = array_of<float>(view["combinations"][0]["sources"][0]["errors"]);
  EXPECT_EQ(errors.size(), 100u);
  EXPECT_EQ(std::count(errors.begin(), errors.end(), 0.0f), 99) << "the first is the truth; the source has no error";
}

TEST_F(ComparisonViews, StayDataWhateverTheInputIsCalled) {
  job_.input = folder_ / "<img src=x>.off";
  std::filesystem::copy(folder_ / "two.off", job_.input);
  EXPECT_NE(data()["input"]["file"].get<std::string>().find("<img"), std::string::npos);
  EXPECT_EQ(read_bytes(job_.page).find("<img"), std::string::npos);
}

TEST_F(ComparisonViews, WithoutATemplateNothingIsComputed) {
  job_.page_template = folder_ / "none.html";
  job_.input = folder_ / "none.off";
  Observer quiet;
  EXPECT_THROW(run_compare(job_, quiet), CapabilityError) << "before the input is even read";
}

}  // namespace
}  // namespace geodrome::testing
