// SPDX-License-Identifier: MIT
// The bench of rows that are prepared together: what it makes, and that it sees what differs.
#include "tools/bench/solvers/matrix_rows.hpp"

#include <gtest/gtest.h>

#include "tools/shapes/small_meshes.hpp"

namespace geodrome::bench {
namespace {

const char* const sound = GEODROME_BINARY_DIR "/tests/sound_plugins";
const char* const faulty = GEODROME_BINARY_DIR "/tests/faulty_solvers";

Plugin<ShortestPathSolver> solver_of(const std::string& selection) {
  return PluginHost({sound, faulty}).load<ShortestPathSolver>(selection);
}

/// On two parts.
MatrixRowsResult rows(const std::string& solver, const MatrixRowsOptions& options = {.rows = 0}) {
  const MeshPtr mesh = shapes::small::both(shapes::small::terrain(7, 1.5, 61), shapes::small::cube());
  return matrix_rows(solver_of(solver), solver_of("chen_han"), mesh, options);
}

TEST(MatrixRows, AreMadeByBothAndCompared) {
  const MatrixRowsResult result = rows("test_together", {.rows = 0, .chunk = 7, .threads = 2});
  EXPECT_TRUE(result.used);
  EXPECT_EQ(result.measures.at("planned_sources"), static_cast<double>(result.vertices));
  EXPECT_EQ(result.rows, result.vertices);
  EXPECT_EQ(result.solver.chunk.size(), (result.rows + 6) / 7);
  EXPECT_EQ(result.peer.chunk.size(), result.solver.chunk.size());
  EXPECT_GT(result.worst_difference, 0) << "the solver marks its rows by a rounding";
  EXPECT_LT(result.worst_difference, 1e-14);
  EXPECT_LT(result.worst_asymmetry, 1e-14);
  EXPECT_EQ(result.solver.bytes, result.peer.bytes + 1'000'000);
}

TEST(MatrixRows, ShowWhatIsWrong) {
  const MatrixRowsResult wrong = rows("faulty_planned_long");
  EXPECT_NEAR(wrong.worst_difference, 1e-6, 1e-12);
  EXPECT_NEAR(wrong.worst_asymmetry, 1e-6, 1e-12);
}

TEST(MatrixRows, AreThoseOfThePlanAlone) {
  const MatrixRowsResult some = rows("test_together", {.rows = 12, .radius = 3, .of_rows_alone = true});
  EXPECT_LE(some.rows, 12u);
  EXPECT_EQ(some.measures.at("planned_sources"), static_cast<double>(some.rows));
  EXPECT_EQ(some.measures.at("planned_radius"), 3);
  EXPECT_LT(some.worst_difference, 1e-14);
}

TEST(MatrixRows, ArePlainWhereThePlanIsNotUsed) {
  const MatrixRowsResult plain = rows("test_together:answer=null");
  EXPECT_FALSE(plain.used);
  EXPECT_EQ(plain.worst_difference, 0);
}

TEST(MatrixRows, AreRefusedToASolverWithoutTheExtension) { EXPECT_THROW(rows("edge_dijkstra"), CapabilityError); }

TEST(MatrixRows, MakeAWholeMatrixWithItsPreparation) {
  MatrixRowsResult result;
  result.vertices = 100, result.rows = 4, result.solver.preparation = 2, result.solver.chunk = {0.5, 1.5};
  EXPECT_DOUBLE_EQ(whole_matrix(result.solver, result), 52);
}

}  // namespace
}  // namespace geodrome::bench
