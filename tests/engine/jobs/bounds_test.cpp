// SPDX-License-Identifier: MIT
// Lower bounds beside distances, as files and in the report.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/samples.hpp"
#include "tests/support/stops_at_rows.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;

/// Two tori, one beside the other.
class Bounds : public ::testing::Test {
 protected:
  Bounds() { write_mesh(file_, *mesh_); }

  DistanceJob job(const std::string& solver) const {
    DistanceJob job{.input = file_, .sources = "0,30,70 + 0.5"};
    job.settings.stages.solver = solver;
    job.settings.threads = 2;
    job.matrix = folder_ / "d.npy", job.bounds = folder_ / "l.npy";
    return job;
  }
  json report_of(const DistanceJob& job) const {
    const JobReport report = run_distances(job, silent_observer());
    EXPECT_TRUE(report.broken_promises.empty()) << report.broken_promises.front();
    return json::parse(report.json);
  }
  Matrix distances() const { return read_npy(folder_ / "d.npy"); }
  Matrix bounds() const { return read_npy(folder_ / "l.npy"); }
  template <class Error>
  std::string refusal(const DistanceJob& job) const {
    try {
      run_distances(job, silent_observer());
      return "done";
    } catch (const Error& error) {
      return error.what();
    }
  }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "m.ply";
  const MeshPtr one_ = test::bumpy_torus(12, 8, 0.05, 2);
  const MeshPtr mesh_ = test::both(one_, test::mapped(one_, [](const Vec3& p) { return p + Vec3{0, 0, 9}; }));
};

TEST_F(Bounds, OfAnExactSolverAreItsDistances) {
  report_of(job("chen_han"));
  EXPECT_EQ(read_bytes(folder_ / "d.npy"), read_bytes(folder_ / "l.npy"));
}

TEST_F(Bounds, OfASolverWithAFactorAloneAreAShareOfIt) {
  report_of(job("aleksandrov:delta=0.25"));
  const Matrix d = distances(), l = bounds();
  for (std::size_t j = 0; j < d.columns; ++j) EXPECT_DOUBLE_EQ(l(0, j), d(0, j) / 1.25);
}

TEST_F(Bounds, OfMergedWindowsAreBelowTheExactDistances) {
  DistanceJob wanted = job("merged_windows:delta=0.1");
  write_bytes(folder_ / "targets.txt", "0-95\n7 0.2 0.3 0.5\n8 0.1 0.1 0.8\n150 0.5 0.5 0\n");
  wanted.targets = "@" + (folder_ / "targets.txt").string();
  wanted.sources = "0,30,70 + 0.5,5 0.2 0.3 0.5";
  report_of(wanted);
  const Matrix upper = distances(), lower = bounds();
  wanted.settings.stages.solver = "chen_han";
  report_of(wanted);
  const Matrix exact = distances();
  double widest = 0;
  for (std::size_t i = 0; i < exact.rows; ++i)
    for (std::size_t j = 0; j < exact.columns; ++j) {
      EXPECT_LE(lower(i, j), exact(i, j) + 1e-12) << i << ", " << j;
      EXPECT_LE(exact(i, j), upper(i, j) + 1e-12) << i << ", " << j;
      if (std::isfinite(exact(i, j))) widest = std::max(widest, upper(i, j) - lower(i, j));
    }
  EXPECT_GT(widest, 1e-3) << "so that there is something to hold";
}

TEST_F(Bounds, BeyondTheLimitAreFiniteAndUnreachableInfinite) {
  for (const char* solver : {"chen_han", "merged_windows:delta=0.01", "merged_windows:delta=0.01,value=middle"}) {
    DistanceJob limited = job(solver);
    limited.max_distance = 1.5;
    report_of(limited);
    const Matrix d = distances(), l = bounds();
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < d.rows; ++i)
      for (std::size_t j = 0; j < d.columns; ++j) {
        if (j >= one_->vertex_count()) {
          EXPECT_EQ(l(i, j), infinity);
        } else if (d(i, j) == infinity) {
          ++beyond;
          EXPECT_TRUE(l(i, j) > 1.48 && l(i, j) < 1.52) << solver << ": " << l(i, j);
        } else {
          EXPECT_LE(l(i, j), d(i, j));
        }
      }
    EXPECT_GT(beyond, 50u);
  }
}

TEST_F(Bounds, OfASourceThatStartsBeyondTheLimitAreItsStart) {
  DistanceJob late = job("merged_windows");
  late.sources = "0 + 3", late.max_distance = 2;
  report_of(late);
  EXPECT_EQ(distances()(0, 5), infinity);
  EXPECT_EQ(bounds()(0, 5), 3);
}

TEST_F(Bounds, AreRoundedDownWhereFloatsAreStored) {
  const auto floats = [&](const char* name) {
    const std::string bytes = read_bytes(folder_ / name);
    std::vector<float> values(mesh_->vertex_count() * 3);
    std::memcpy(values.data(), bytes.data() + bytes.size() - 4 * values.size(), 4 * values.size());
    return values;
  };
  DistanceJob single = job("chen_han");
  report_of(single);
  const Matrix exact = distances();
  single.scalar = ScalarType::float32;
  report_of(single);
  const std::vector<float> d = floats("d.npy"), l = floats("l.npy");
  std::size_t above = 0;
  for (std::size_t k = 0; k < l.size(); ++k) {
    EXPECT_LE(l[k], exact.values[k]);
    above += d[k] > exact.values[k];
    if (std::isfinite(l[k])) {
      EXPECT_GE(std::nextafter(l[k], 100.0F), exact.values[k]);
    }
  }
  EXPECT_GT(above, 10u) << "the nearest float is above as often as below";
}

TEST_F(Bounds, AreTheSameBytesForAnyNumberOfThreadsAndAfterAResumedRun) {
  DistanceJob all = job("merged_windows:delta=0.01");
  all.sources = "all", all.settings.threads = 1;
  const json alone = report_of(all);
  const std::string whole = read_bytes(folder_ / "l.npy");
  all.settings.threads = 3;
  EXPECT_EQ(report_of(all)["matrix"]["certified"], alone["matrix"]["certified"]);
  EXPECT_EQ(read_bytes(folder_ / "l.npy"), whole);
  for (const bool with_bounds : {true, false}) {  // of a run without bounds every row is made again
    DistanceJob half = all;
    if (!with_bounds) half.bounds.clear();
    test::StopsAtRows observer(0.3);
    EXPECT_THROW(run_distances(half, observer), Cancelled);
    std::filesystem::remove(folder_ / "l.npy");
    all.resume = true;
    report_of(all);
    EXPECT_EQ(read_bytes(folder_ / "l.npy"), whole);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "l.npy.partial"));
    all.resume = false;
  }
}

TEST_F(Bounds, AreAColumnOfTheNearestSources) {
  DistanceJob nearest = job("merged_windows:delta=0.1");
  nearest.matrix.clear(), nearest.bounds.clear();
  nearest.nearest = folder_ / "n.csv", nearest.nearest_bounds = true;
  report_of(nearest);
  std::istringstream lines(read_bytes(folder_ / "n.csv"));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "target,distance,source,reach,lower_bound");
  std::getline(lines, line);
  EXPECT_EQ(line, "0,0,0,reached,0");
  for (std::size_t j = 1; std::getline(lines, line); ++j) {
    const double d = std::stod(line.substr(line.find(',') + 1)), l = std::stod(line.substr(line.rfind(',') + 1));
    EXPECT_LE(l, d) << line;
    EXPECT_GE(1.1 * l * (1 + 1e-12), d) << line;
    EXPECT_EQ(std::isinf(l), j >= one_->vertex_count()) << line;
  }
}

TEST_F(Bounds, OfACloudReckonWithTheStraightLine) {
  write_points(folder_ / "t.xyz", test::torus(1000, 1).points);
  DistanceJob cloud = job("merged_windows:delta=0.3");
  cloud.input = folder_ / "t.xyz", cloud.sources = "0,7";
  report_of(cloud);
  const Matrix upper = distances(), lower = bounds();
  cloud.settings.stages.solver = "chen_han";
  report_of(cloud);
  const Matrix exact = distances();
  for (std::size_t k = 0; k < exact.values.size(); ++k) {
    EXPECT_LE(lower.values[k], exact.values[k] + 1e-12);
    EXPECT_LE(exact.values[k], upper.values[k] + 1e-12);
  }
  cloud.settings.stages.solver = "merged_windows:delta=0.3", cloud.query = ProjectionRule::insert;
  report_of(cloud);
  const Matrix inserted = distances(), inserted_bounds = bounds();
  for (std::size_t k = 0; k < inserted.values.size(); ++k) EXPECT_LE(inserted_bounds.values[k], inserted.values[k]);
}

TEST_F(Bounds, AreCertifiedInTheReport) {
  const JobReport report = run_distances(job("merged_windows:delta=0.01"), silent_observer());
  const json certified = json::parse(report.json)["matrix"]["certified"];
  EXPECT_EQ(certified["vertices"], 3 * one_->vertex_count());
  EXPECT_GT(certified["mean"], 0);
  EXPECT_GT(certified["largest"], certified["mean"]);
  EXPECT_LE(certified["largest"], 0.01 * (1 + 1e-12));
  EXPECT_NE(report.summary.find("certified  off by at most"), std::string::npos) << report.summary;
  const JobReport exact = run_distances(job("chen_han"), silent_observer());
  EXPECT_EQ(exact.json.find("certified"), std::string::npos);
  EXPECT_EQ(exact.summary.find("certified"), std::string::npos);
}

TEST_F(Bounds, AreRefusedWhereThereAreNone) {
  EXPECT_EQ(refusal<CapabilityError>(job("edge_dijkstra")),
            "solver_edge_dijkstra gives no lower bounds: it states neither bounds nor a factor; choose a solver with a "
            "finite factor (`PluginInfo::default_factor` tells); the distances of an exact one are their own lower "
            "bounds");
  DistanceJob printed = job("merged_windows");
  printed.query = ProjectionRule::printed;
  EXPECT_NE(refusal<OptionError>(printed).find("has no lower bounds"), std::string::npos);
  DistanceJob alone = job("merged_windows");
  alone.matrix.clear(), alone.nearest = folder_ / "n.csv";
  EXPECT_NE(refusal<OptionError>(alone).find("`matrix`"), std::string::npos);
  DistanceJob no_table = job("merged_windows");
  no_table.nearest_bounds = true;
  EXPECT_NE(refusal<OptionError>(no_table).find("`nearest`"), std::string::npos);
  DistanceJob same = job("merged_windows");
  same.bounds = same.matrix;
  EXPECT_NE(refusal<OptionError>(same).find("named for two outputs"), std::string::npos);
}

TEST_F(Bounds, InMemoryAreThoseOfTheJob) {
  const DistanceJob wanted = job("merged_windows:delta=0.01");
  report_of(wanted);
  const Session session(file_, wanted.settings);
  const auto sources = session.select(wanted.sources), targets = session.select("all");
  const BoundedDistances bounded = session.bounded_distances(sources, targets);
  EXPECT_EQ(bounded.distances, distances().values);
  EXPECT_EQ(bounded.bounds, bounds().values);
  RunSettings settings;
  settings.stages.solver = "edge_dijkstra";
  EXPECT_THROW(Session(file_, settings).bounded_distances(sources, targets), CapabilityError);
  EXPECT_THROW(session.bounded_distances(sources, targets, {.rule = ProjectionRule::printed}), OptionError);
}

/// A path is real, so that where it is shorter than the distance it is the better of the two.
TEST_F(Bounds, APathThatIsShorterThanTheDistanceIsTheDistance) {
  RunSettings settings;
  settings.stages.solver = "merged_windows:delta=0.3";
  const Session session(file_, settings);
  settings.stages.solver = "chen_han";
  const Session exact(file_, settings);
  const auto all = session.select("0-95");
  std::size_t better = 0;
  for (const NamedPoint& to : all) {
    const PathResult path = session.path(all[3], to);
    const double upper = session.distances({&all[3], 1}, {&to, 1})[0];
    EXPECT_EQ(path.distance, std::min(upper, path.points.empty() ? upper : path.length));
    EXPECT_GE(path.distance, exact.path(all[3], to).distance - 1e-12);
    EXPECT_TRUE(session.audit_path(all[3], to, path).empty());
    better += path.distance < upper;
  }
  EXPECT_GT(better, 10u);
}

}  // namespace
}  // namespace geodrome::testing
