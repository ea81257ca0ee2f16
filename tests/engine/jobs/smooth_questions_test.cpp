// SPDX-License-Identifier: MIT
// Paths, nearest sources, pairs and places under the smooth metric.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/engine/jobs/smooth_fixture.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/same_bytes.hpp"
#include "tools/shapes/meshes.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;
using test::same_bytes;

/// What rows that are carried over the surface may differ from paths that are shortened one by one, relative.
constexpr double carried = 1e-5;

TEST_F(SmoothMetric, HasThePathsOfItsDistances) {
  DistanceJob some = job();
  some.sources = "7";
  const Matrix matrix = made(some);
  const Session session(file_, settings());
  for (const Index to : {7u, 8u, 100u, 499u}) {
    const auto ends = session.select(std::vector<Index>{7, to});
    const PathResult path = session.path(ends[0], ends[1]);
    EXPECT_NEAR(path.distance, matrix(0, to), carried * matrix(0, to));
    EXPECT_EQ(session.audit_path(ends[0], ends[1], path), std::vector<std::string>{});
    ASSERT_EQ(path.points.size(), path.positions.size());
    if (to == 7) continue;
    for (const Vec3& p : path.positions) EXPECT_NEAR(norm(p), 1, 1e-14);
    PathResult wrong = path;
    wrong.length *= 1 + 1e-12, wrong.distance *= 1 + 1e-12;
    EXPECT_EQ(session.audit_path(ends[0], ends[1], wrong).size(), 1u);
  }
  PathJob job{.input = file_, .settings = settings(), .from = "7", .to = "100", .out = folder_ / "p.csv"};
  EXPECT_NEAR(run_path(job, silent_observer()).distance, matrix(0, 100), carried * matrix(0, 100));
}

TEST_F(SmoothMetric, WritesTheFlatPathBesideTheCurve) {
  const Session session(file_, settings());
  const auto ends = session.select("7,100");
  const PathResult curve = session.path(ends[0], ends[1]),
                   flat = Session(file_, settings(Metric::flat)).path(ends[0], ends[1]);
  ASSERT_TRUE(curve.flat);
  EXPECT_EQ(curve.flat->length, flat.length);
  EXPECT_EQ(curve.flat->points, flat.points);
  EXPECT_FALSE(flat.flat);
  PathJob job{.input = file_, .settings = settings(), .from = "7", .to = "100", .flat = folder_ / "f.json"};
  run_path(job, silent_observer());
  const json written = json::parse(read_bytes(job.flat));
  EXPECT_EQ(written["length"], flat.length);
  EXPECT_EQ(written["points"].size(), flat.points.size());
  job.settings.metric = Metric::flat;
  EXPECT_THROW(run_path(job, silent_observer()), OptionError);
  job.settings.metric = Metric::smooth, job.out = job.flat;
  EXPECT_THROW(run_path(job, silent_observer()), OptionError) << "one file for both";
}

TEST_F(SmoothMetric, NamesTheSourceThatIsNearestOnTheSmoothSurface) {
  const Session session(file_, settings()), flat(file_, settings(Metric::flat));
  for (const double limit : {infinity, 0.15}) {
    auto sources = session.select("0:500:5");
    const auto all = session.select("all");
    sources[3].start = 0.02;
    const std::vector<double> rows = session.distances(sources, all);
    const std::vector<Distance> nearest = session.nearest(sources, all, limit);
    const std::vector<Distance> on_triangles = flat.nearest(sources, all, limit);
    std::size_t renamed = 0, reached = 0;
    for (std::size_t j = 0; j < all.size(); ++j) {
      double least = infinity;
      for (std::size_t i = 0; i < sources.size(); ++i) least = std::min(least, rows[i * all.size() + j]);
      if (std::abs(least / limit - 1) > carried) {
        EXPECT_EQ(nearest[j].reach == Reach::reached, least <= limit) << j;
      }
      if (nearest[j].reach != Reach::reached) continue;
      EXPECT_NEAR(nearest[j].value, least, carried * least) << j;
      EXPECT_NEAR(rows[nearest[j].source * all.size() + j], least, carried * least) << j;
      ++reached, renamed += nearest[j].source != on_triangles[j].source;
    }
    EXPECT_GT(renamed, 0u);
    EXPECT_GT(reached, 200u);
    EXPECT_EQ(session.audit_nearest(sources, all, nearest, limit), std::vector<std::string>{});
  }
}

TEST_F(SmoothMetric, OfNearestSourcesIsAuditedAndTold) {
  const Session session(file_, settings());
  const auto sources = session.select("0,7 + 0.2,9"), all = session.select("all");
  std::vector<Distance> nearest = session.nearest(sources, all, 1.5);
  EXPECT_EQ(session.audit_nearest(sources, all, nearest, 1.5), std::vector<std::string>{});
  nearest[3].value *= 1 + 1e-12;
  EXPECT_EQ(session.audit_nearest(sources, all, nearest, 1.5).size(), 1u);
  DistanceJob job{.input = file_, .settings = settings(), .sources = "0,7,9", .nearest = folder_ / "n.csv"};
  const json found = json::parse(run(job).json)["nearest"];
  EXPECT_TRUE(found.contains("smooth"));
  EXPECT_EQ(found["compared_sources"], 3);
}

TEST_F(SmoothMetric, OfPairsIsThatOfRows) {
  write_bytes(folder_ / "p.txt", "3, 17\n8, 8\n3, 400\n17, 3\n0.1 0.2 0.97, 3\n");
  const Session session(file_, settings());
  const PairList list = select_pairs(folder_ / "p.txt", session.input(), session.surface());
  const std::vector<double> values = session.pairs(list.pairs);
  for (std::size_t i = 0; i < list.pairs.size(); ++i)
    EXPECT_NEAR(values[i], session.distances({&list.pairs[i].from, 1}, {&list.pairs[i].to, 1})[0], 1e-13) << i;
  EXPECT_EQ(values[1], 0);
  EXPECT_NEAR(values[0], arc(points_[3], points_[17]), 1e-4);
  EXPECT_EQ(session.audit_pairs(list.pairs, values), std::vector<std::string>{});
  std::vector<double> wrong = values;
  wrong[2] *= 1 + 1e-9;
  EXPECT_EQ(session.audit_pairs(list.pairs, wrong).size(), 1u);

  PairJob job{.input = file_, .settings = settings(), .pairs = folder_ / "p.txt", .out = folder_ / "p.npy"};
  const JobReport report = run_pairs(job, silent_observer());
  EXPECT_EQ(report.broken_promises, std::vector<std::string>{});
  EXPECT_TRUE(same_bytes(read_npy(job.out).values, values));
  const json found = json::parse(report.json);
  EXPECT_FALSE(found.contains("oracle"));
  EXPECT_EQ(found["pairs"]["searches"], 4);
  EXPECT_EQ(found["pairs"]["smooth"]["paths"], 4);
  EXPECT_EQ(found["audit"]["audited"], true);
  EXPECT_NE(report.summary.find("5 in "), std::string::npos) << report.summary;
  EXPECT_NE(report.summary.find("\nsmooth     100 % of the length"), std::string::npos) << report.summary;
  job.settings.threads = 1;
  run_pairs(job, silent_observer());
  EXPECT_TRUE(same_bytes(read_npy(job.out).values, values));
}

TEST_F(SmoothMetric, OfAPointNamedByItsCoordinatesIsThatOfItsRow) {
  const Session session(file_, settings());
  const auto all = session.select("all"), named = session.select(points_);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(named[i].place.at, all[i].place.at) << i;
    moved += all[i].place.vertex == no_index;
  }
  EXPECT_GT(moved, 100u);
  const std::span<const NamedPoint> rows(&all[3], 5), places(&named[3], 5);
  EXPECT_EQ(session.distances(places, named), session.distances(rows, all));
  EXPECT_EQ(session.path(named[3], named[77]).distance, session.path(all[3], all[77]).distance);
  const std::vector<Distance> to_rows = session.nearest(rows, all), to_places = session.nearest(places, named);
  for (std::size_t j = 0; j < all.size(); ++j) EXPECT_EQ(to_rows[j].value, to_places[j].value);
  DistanceJob by_place = job(), by_row = job();
  by_place.targets = "@" + (folder_ / "s.xyz").string();
  by_place.sources = "@" + (folder_ / "some.xyz").string();
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < points_.size(); i += 25) some.push_back(points_[i]);
  write_points(folder_ / "some.xyz", some);
  EXPECT_EQ(made(by_place).values, made(by_row).values);
}

TEST_F(SmoothMetric, OfAPointBesideAMeshIsOfTheClosestOnTheSmoothSurface) {
  write_mesh(folder_ / "m.ply", shapes::icosphere(320));
  const Session session(folder_ / "m.ply", settings());
  const auto named = session.select(std::span(points_).first(60));
  const std::vector<double> d = session.distances({&named[0], 1}, named);
  for (std::size_t j = 1; j < named.size(); ++j)
    EXPECT_NEAR(d[j], arc(points_[0], points_[j]), (1 + d[j]) * carried) << j;
}

}  // namespace
}  // namespace geodrome::testing
