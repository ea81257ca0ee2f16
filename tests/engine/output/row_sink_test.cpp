// SPDX-License-Identifier: MIT
#include "geodrome/engine/row_sink.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
const double nan = std::nan("");

/// A row whose values no other row has.
std::vector<double> row_values(std::uint64_t row, std::uint64_t columns) {
  std::vector<double> values(columns);
  for (std::uint64_t i = 0; i < columns; ++i) values[i] = static_cast<double>(row * columns + i) / 3;
  return values;
}

/// Writes all rows from four threads, each taking every fourth one from the end.
void write_from_threads(RowSink& sink, std::uint64_t rows, std::uint64_t columns) {
  std::vector<std::jthread> threads;
  for (std::uint64_t first = 0; first < 4; ++first)
    threads.emplace_back([&sink, first, rows, columns] {
      for (std::uint64_t k = first; k < rows; k += 4) sink.write(rows - 1 - k, row_values(rows - 1 - k, columns));
    });
}

TEST(MatrixInMemory, HoldsEveryRowAtItsPlaceWhateverThreadWroteIt) {
  std::vector<double> array(101 * 7, -1);
  MatrixInMemory<double> matrix(array, 101, 7);
  write_from_threads(matrix, 101, 7);
  matrix.finish();
  for (std::uint64_t i = 0; i < array.size(); ++i) EXPECT_EQ(array[i], static_cast<double>(i) / 3);
}

TEST(MatrixInMemory, RoundsToFloat) {
  std::vector<float> array(4, -1);
  MatrixInMemory<float> matrix(array, 2, 2);
  matrix.write(1, std::vector<double>{0.1, inf});
  EXPECT_EQ(array[2], 0.1F);
  EXPECT_EQ(array[3], std::numeric_limits<float>::infinity());
  EXPECT_EQ(array[0], -1) << "a row that nobody wrote was touched";
}

TEST(MatrixInMemory, RefusesADistanceThatFloatWouldChangeInKind) {
  std::vector<float> array(2);
  MatrixInMemory<float> matrix(array, 1, 2);
  EXPECT_THROW(matrix.write(0, std::vector<double>{1, 1e300}), OptionError);
  EXPECT_THROW(matrix.write(0, std::vector<double>{1e-300, 1}), OptionError);
  EXPECT_FALSE(matrix.has(0));
}

TEST(MatrixInMemory, KnowsWhichRowsAreThere) {
  std::vector<double> array(6);
  MatrixInMemory<double> matrix(array, 3, 2);
  matrix.write(1, std::vector<double>{1, 2});
  EXPECT_FALSE(matrix.has(0));
  EXPECT_TRUE(matrix.has(1));
  EXPECT_FALSE(matrix.has(3));
  EXPECT_THROW(matrix.finish(), std::logic_error);
}

TEST(MatrixInMemory, RefusesAnArrayOfAnotherSize) {
  std::vector<double> array(5);
  EXPECT_THROW(MatrixInMemory<double>(array, 3, 2), std::logic_error);
  EXPECT_THROW(MatrixInMemory<double>(array, std::uint64_t{1} << 63, 2), std::logic_error);
}

TEST(RowSink, RefusesARowOfTheWrongLengthOrPlace) {
  std::vector<double> array(6);
  MatrixInMemory<double> matrix(array, 3, 2);
  RowStatistics statistics(3, 2);
  for (RowSink* sink : {static_cast<RowSink*>(&matrix), static_cast<RowSink*>(&statistics)}) {
    EXPECT_THROW(sink->write(0, std::vector<double>{1}), std::logic_error);
    EXPECT_THROW(sink->write(3, std::vector<double>{1, 2}), std::logic_error);
  }
}

TEST(RowStatistics, CountsReachedUnreachableAndDroppedApart) {
  RowStatistics statistics(1, 6);
  statistics.write(0, std::vector<double>{0, 1, inf, nan, 5, inf});
  EXPECT_EQ(statistics.rows()[0], (RowSummary{.reached = 3, .unreachable = 2, .dropped = 1, .mean = 2, .max = 5}));
}

TEST(RowStatistics, HasNoMeanWhereNothingIsReached) {
  RowStatistics statistics(2, 2);
  statistics.write(0, std::vector<double>{inf, inf});
  statistics.write(1, std::vector<double>{nan, nan});
  for (const RowSummary& row : statistics.rows()) {
    EXPECT_EQ(row.reached, 0U);
    EXPECT_TRUE(std::isnan(row.mean));
    EXPECT_TRUE(std::isnan(row.max));
  }
  EXPECT_EQ(statistics.rows()[0].unreachable, 2U);
  EXPECT_EQ(statistics.rows()[1].dropped, 2U);
}

TEST(RowStatistics, DoesNotDependOnTheOrderOfTheRows) {
  RowStatistics threaded(101, 7), plain(101, 7);
  write_from_threads(threaded, 101, 7);
  for (std::uint64_t row = 0; row < 101; ++row) plain.write(row, row_values(row, 7));
  threaded.finish();
  for (std::uint64_t row = 0; row < 101; ++row) {
    EXPECT_EQ(threaded.rows()[row], plain.rows()[row]);
    EXPECT_EQ(plain.rows()[row].max, row_values(row, 7).back());
  }
}

TEST(RowStatistics, MissesNoRowAtTheEnd) {
  RowStatistics statistics(2, 1);
  statistics.write(1, std::vector<double>{1});
  EXPECT_FALSE(statistics.has(0));
  EXPECT_THROW(statistics.finish(), std::logic_error);
}

}  // namespace
}  // namespace geodrome
