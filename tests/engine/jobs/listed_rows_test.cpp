// SPDX-License-Identifier: MIT
// Matrices by the row lists of chen_han: threads, sets of rows and resumed runs do not show in a byte.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/npy.hpp"
#include "tests/support/stops_at_rows.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::testing {
namespace {

using nlohmann::json;

/// What a job asks for, beside the mesh.
struct Asked {
  std::string name, sources = "all", targets = "all";
  double max_distance = infinity;
};

class ListedRows : public ::testing::TestWithParam<Asked> {
 protected:
  ListedRows() { write_mesh(file_, *mesh_); }

  DistanceJob job(const std::string& rows = "lists", unsigned threads = 2) const {
    DistanceJob job{.input = file_};
    job.settings.stages.solver = "chen_han:rows=" + rows;
    job.settings.threads = threads;
    job.sources = GetParam().sources, job.targets = GetParam().targets;
    job.max_distance = GetParam().max_distance;
    job.matrix = matrix_, job.bounds = bounds_;
    return job;
  }
  json run(const DistanceJob& job) const {
    const JobReport report = run_distances(job, silent_observer());
    EXPECT_TRUE(report.broken_promises.empty()) << report.broken_promises.front();
    return json::parse(report.json)["matrix"];
  }
  /// Of both files.
  std::string bytes() const { return read_bytes(matrix_) + read_bytes(bounds_); }

  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "m.ply", matrix_ = folder_ / "d.npy", bounds_ = folder_ / "l.npy";
  const MeshPtr mesh_ = test::both(test::bumpy_torus(20, 14, 0.15, 5), test::terrain(9, 1, 2));
};

TEST_P(ListedRows, AreThoseOfPlainSearchesWithBoundsBelowThem) {
  run(job("plain"));
  const Matrix plain = read_npy(matrix_);
  EXPECT_EQ(run(job())["many_searches"]["used"], true);
  const Matrix listed = read_npy(matrix_), below = read_npy(bounds_);
  ASSERT_EQ(listed.values.size(), plain.values.size());
  constexpr double rounding = 1e-12;
  for (std::size_t k = 0; k < plain.values.size(); ++k) {
    ASSERT_TRUE(listed.values[k] == plain.values[k] ||
                std::abs(listed.values[k] - plain.values[k]) <= rounding * plain.values[k])
        << listed.values[k] << " is not " << plain.values[k];
    ASSERT_LE(below.values[k], listed.values[k]);
  }
}

TEST_P(ListedRows, HaveTheSameBytesForAnyNumberOfThreads) {
  EXPECT_EQ(run(job("lists", 1))["many_searches"]["used"], true);
  const std::string one = bytes();
  for (const unsigned threads : {2U, 4U}) {
    run(job("lists", threads));
    EXPECT_EQ(bytes(), one) << threads << " threads";
  }
}

TEST_P(ListedRows, HaveTheSameBytesAfterAResumedRun) {
  for (const ScalarType scalar : {ScalarType::float64, ScalarType::float32}) {
    DistanceJob all = job();
    all.scalar = scalar;
    run(all);
    const std::string whole = bytes();
    test::StopsAtRows observer(0.4);
    EXPECT_THROW(run_distances(all, observer), Cancelled);
    all.resume = true, all.settings.threads = 3;
    const json found = run(all);
    EXPECT_GT(found["resumed_rows"], 5);
    EXPECT_EQ(found["many_searches"]["used"], true);
    EXPECT_EQ(bytes(), whole);
  }
}

TEST_P(ListedRows, HaveTheSameBytesFromSetsOfRowsOfASession) {
  run(job());
  const std::vector<double> expected = read_npy(matrix_).values;
  const Session session(file_, job().settings);
  const auto from = session.select(GetParam().sources), to = session.select(GetParam().targets);
  std::vector<double> rows(expected.size(), -1);
  MatrixInMemory<double> sink(rows, from.size(), to.size());
  for (const std::uint64_t part : {2, 0, 1})
    session.distances(from, to, sink, {.max_distance = GetParam().max_distance}, RowSet::part(part, 3, from.size()));
  EXPECT_EQ(rows, expected);
}

INSTANTIATE_TEST_SUITE_P(Jobs, ListedRows,
                         ::testing::Values(Asked{"all"}, Asked{.name = "cut_off", .max_distance = 0.6},
                                           Asked{"region", "10:200:3", "5-120,300"},
                                           Asked{"starts", "40,0-60,7,40 + 0.2,300-320", "all", 1.1},
                                           Asked{"square_region", "1:280:2", "1:280:2", 1.5}),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace geodrome::testing
