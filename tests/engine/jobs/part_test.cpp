// SPDX-License-Identifier: MIT
// The part of a sample that makes a surface: told where the whole is refused, given on request, NaN beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "geodrome/engine/session.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/scans.hpp"
#include "tests/support/stops_at_rows.hpp"

namespace geodrome::testing {
namespace {

using Json = nlohmann::json;

/// A unit sphere in 5 % of outliers, and far off it half as many points on a plane.
struct Scene {
  static constexpr Index on_sphere = 2000, on_plane = 1000, outliers = 150;
  PointSample sample = test::sphere(on_sphere, 1);

  Scene() {
    for (const Vec3& p : test::plane(on_plane, 2).points) sample.points.push_back({2 * p.x + 3, 2 * p.y, p.z});
    test::add_outliers(sample, outliers, 2.5, 3);
  }
  Index rows() const { return static_cast<Index>(sample.size()); }
};

/// Points of which no reconstructor makes a surface, with a sphere beside them that is one.
PointSample cloud_and_sphere(std::size_t on_sphere, std::size_t in_cloud) {
  PointSample sample = test::sphere(on_sphere, 1);
  for (const Vec3& p : test::cube(in_cloud, 2).points) sample.points.push_back(p * 2 + Vec3{2, 0, 0});
  return sample;
}

class Parts : public ::testing::Test {
 protected:
  Parts() { largest_.part = Part::largest; }

  std::filesystem::path written(const PointSample& sample) const {
    write_points(folder_ / "s.ply", sample.points);
    return folder_ / "s.ply";
  }
  Session session(const PointSample& sample) const {
    return Session(make_input({.positions = sample.points}), largest_);
  }

  const TemporaryFolder folder_;
  RunSettings largest_;
};

/// Mean and largest relative error of far pairs on the part: from its middle row, against the truth.
template <class Truth>
std::pair<double, double> errors(const Session& on, double far, Truth&& truth) {
  const PlacedSurface& surface = on.surface();
  const Index from = surface.part->row;
  const std::vector<double> found = on.distances(on.select(std::vector{from}), on.select("all"));
  double sum = 0, largest = 0, count = 0;
  for (Index row = 0; row < found.size(); ++row) {
    const Vec3 &s = surface.places[from].position, &t = surface.places[row].position;
    if (std::isnan(found[row]) || truth(s, t) < far) continue;
    const double error = std::abs(found[row] / truth(s, t) - 1);
    sum += error, largest = std::max(largest, error), ++count;
  }
  return {sum / count, largest};
}

double on_unit_sphere(const Vec3& s, const Vec3& t) { return 2 * std::asin(std::min(1.0, distance(s, t) / 2)); }

TEST_F(Parts, OfASphereInOutliersHasItsDistances) {
  const Scene scene;
  const Session on = session(scene.sample);
  const SurfacePart& part = *on.surface().part;
  EXPECT_EQ(part.sample, scene.rows());
  EXPECT_GE(part.points, 0.99 * Scene::on_sphere);
  for (Index row = 0; row < scene.rows(); ++row)
    if (on.surface().places[row].state == Place::State::on_surface)
      EXPECT_NEAR(norm(scene.sample.points[row]), 1, 0.12) << "an outlier that is no neighbour: row " << row;
  const auto [mean, largest] = errors(on, 0.8, on_unit_sphere);
  EXPECT_LT(mean, 4e-3) << "that of a clean sample";
  EXPECT_LT(largest, 3e-2);
}

TEST_F(Parts, OfADoubledNoisyPlaneHasItsDistances) {
  const Session on = session(test::doubled_plane(4000, 4));
  EXPECT_GE(on.surface().part->share(), 0.9);
  const auto [mean, of_all] = errors(on, 0.3, [](const Vec3& s, const Vec3& t) { return distance(s, t); });
  EXPECT_LT(mean, 1e-3);
  // The rim is ragged: a way to a point on it may have to go around a bay between two others.
  const auto off_the_rim = [&](const Vec3& s, const Vec3& t) {
    const double to_rim = std::min({t.x, t.y, 1 - t.x, 1 - t.y});
    return to_rim < on.surface().part->spacing ? 0 : distance(s, t);  // 0: not far, so not looked at
  };
  const auto [mean_inside, largest_inside] = errors(on, 0.3, off_the_rim);
  EXPECT_LT(mean_inside, 1e-3);
  EXPECT_LT(largest_inside, 2e-3);
}

TEST_F(Parts, OfADepthImageDoNotCrossTheJump) {
  const test::DepthImage image = test::depth_image(70, 5);
  const Session on = session({image.points});
  const auto kind_of = [&](Index row) { return image.kind[row]; };
  const test::DepthImage::Kind kind = kind_of(on.surface().part->row);
  for (Index row = 0; row < image.points.size(); ++row)
    if (on.surface().places[row].state == Place::State::on_surface)
      EXPECT_TRUE(kind_of(row) == kind || kind_of(row) == test::DepthImage::flying) << row;
  const auto [mean, largest] = errors(on, 0.2, [](const Vec3& s, const Vec3& t) { return distance(s, t); });
  EXPECT_LT(mean, 5e-3);
}

TEST_F(Parts, AreToldWhereTheWholeIsRefused) {
  const PointSample sample = cloud_and_sphere(1500, 1500);
  const std::filesystem::path file = written(sample);
  try {
    run_distances({.input = file, .sources = "0", .matrix = folder_ / "d.npy"}, silent_observer());
    FAIL() << "the whole is no surface";
  } catch (const SampleError& error) {
    EXPECT_EQ(exit_status(error), 4);
    EXPECT_EQ(error.coded_remedy().code, "part.take");
    EXPECT_NE(error.remedy().find(" of 3000 points ("), std::string::npos) << error.remedy();
    EXPECT_FALSE(error.plugin().empty());
  }
  const CheckReport report = run_check({.input = file}, silent_observer());
  const Json part = Json::parse(report.json).at("part");
  EXPECT_FALSE(part.at("taken"));
  EXPECT_GE(part.at("points"), 1400);
  EXPECT_EQ(part.at("of"), 3000);
  EXPECT_LT(part.at("row"), 1500);
  EXPECT_NE(report.text.find("makes a surface by itself"), std::string::npos);
}

TEST_F(Parts, AreDeniedWhereThereAreNone) {
  const std::filesystem::path file = written(test::cube(3000, 6));
  for (const Part wanted : {Part::whole, Part::largest}) {
    const CheckReport report = run_check({.input = file, .settings = {.part = wanted}}, silent_observer());
    ASSERT_TRUE(report.refusal);
    EXPECT_NE(report.refusal->message().find("no part of the sample makes a surface by itself"), std::string::npos);
    EXPECT_EQ(Json::parse(report.json).at("part").at("points"), 0);
  }
}

TEST_F(Parts, LeaveNaNInRowsAndColumnsBesideThem) {
  const PointSample sample = cloud_and_sphere(500, 300);
  DistanceJob job{.input = written(sample), .settings = largest_, .matrix = folder_ / "d.npy"};
  job.report = folder_ / "d.json", job.nearest = folder_ / "n.csv", job.surface = folder_ / "part.ply";
  const JobReport report = run_distances(job, silent_observer());
  EXPECT_TRUE(report.broken_promises.empty());
  const Session on(job.input, largest_);
  const Matrix matrix = read_npy(job.matrix);
  ASSERT_EQ(matrix.rows, 800u);
  const auto state = [&](std::size_t row) { return on.surface().places[row].state; };
  for (std::size_t i = 0; i < 800; ++i)
    for (std::size_t j = 0; j < 800; ++j) {
      const bool both = state(i) == Place::State::on_surface && state(j) == Place::State::on_surface;
      ASSERT_EQ(std::isnan(matrix(i, j)), !both) << i << ", " << j;
      ASSERT_FALSE(std::isinf(matrix(i, j)));
    }
  const Json json = Json::parse(report.json);
  EXPECT_EQ(json.at("geodrome").at("part"), "largest");
  EXPECT_EQ(json.at("part").at("points"), on.surface().part->points);
  EXPECT_NE(report.summary.find("\npart       "), std::string::npos);
  EXPECT_EQ(json.at("surface").at("findings").back().at("code"), "part");
  EXPECT_EQ(read_input(job.surface).positions.size(), on.surface().mesh->vertex_count());
  const std::string nearest = read_bytes(job.nearest);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(nearest, '\n')), 801u);
  EXPECT_NE(nearest.find(",nan,,off_part\n"), std::string::npos);
}

TEST_F(Parts, GiveTheSameBytesForAnyThreadsAndAfterAResume) {
  DistanceJob job{.input = written(cloud_and_sphere(500, 300)), .settings = largest_, .matrix = folder_ / "d.npy"};
  job.settings.threads = 1;
  run_distances(job, silent_observer());
  const std::string expected = read_bytes(job.matrix);
  job.settings.threads = 3;
  run_distances(job, silent_observer());
  EXPECT_EQ(read_bytes(job.matrix), expected);

  test::StopsAtRows stop(0.3);
  EXPECT_THROW(run_distances(job, stop), Cancelled);
  EXPECT_EQ(read_bytes(job.matrix), expected) << "the finished one is still there";
  job.resume = true;
  run_distances(job, silent_observer());
  EXPECT_EQ(read_bytes(job.matrix), expected);
}

TEST_F(Parts, RefuseNamedSourcesBesideThem) {
  DistanceJob job{.input = written(cloud_and_sphere(500, 300)), .settings = largest_, .matrix = folder_ / "d.npy"};
  for (const std::string source : {"0,700", "@sources.txt"}) {
    write_bytes(folder_ / "sources.txt", "3 0.5 0.5\n");
    job.sources = source.front() == '@' ? "@" + (folder_ / "sources.txt").string() : source;
    try {
      run_distances(job, silent_observer());
      ADD_FAILURE() << source;
    } catch (const InputError& error) {
      EXPECT_EQ(exit_status(error), 3);
      EXPECT_NE(error.message().find("is not on the part of the sample"), std::string::npos) << error.what();
      EXPECT_NE(error.remedy().find("such as row "), std::string::npos);
    }
  }
  const Session on(job.input, largest_);
  const auto at = on.select(std::vector<Index>{0, 700});
  EXPECT_THROW(on.path(at[0], at[1]), InputError);
  EXPECT_TRUE(std::isnan(on.distances(at, at)[1]));
}

TEST_F(Parts, HaveNaNForPairsBesideThem) {
  PairJob job{.input = written(cloud_and_sphere(500, 300)), .settings = largest_};
  job.settings.stages.solver = "aleksandrov", job.settings.stages.decimator = "greedy";
  job.pairs = folder_ / "p.txt", job.out = folder_ / "p.csv";
  write_bytes(job.pairs, "0, 1\n0, 700\n700, 0\n");
  const JobReport report = run_pairs(job, silent_observer());
  EXPECT_TRUE(report.broken_promises.empty());
  const std::string csv = read_bytes(job.out);
  EXPECT_NE(csv.find("\n1,0,700,nan,off_part\n2,700,0,nan,off_part\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",reached\n1,"), std::string::npos) << csv;
}

TEST_F(Parts, AreOfPointSamplesAlone) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const std::vector<Triangle> face{{0, 1, 2}};
  EXPECT_THROW(Session(make_input({.positions = square, .faces = face}), largest_), OptionError);
}

TEST_F(Parts, OfWholeSamplesAreTheWhole) {
  const PointSample sample = test::sphere(1000, 9);
  const Session on = session(sample);
  EXPECT_EQ(on.surface().part->share(), 1);
  const Session whole(make_input({.positions = sample.points}));
  const auto all = on.select("all");
  EXPECT_EQ(on.distances(all, all), whole.distances(whole.select("all"), whole.select("all")));
}

}  // namespace
}  // namespace geodrome::testing
