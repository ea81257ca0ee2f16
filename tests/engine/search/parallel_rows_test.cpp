// SPDX-License-Identifier: MIT
#include "engine/search/parallel_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace geodrome {
namespace {

class CancellableContext : public QuietContext {
 public:
  bool cancelled() const noexcept override { return cancel; }
  std::atomic<bool> cancel = false;
};

/// Throws in the given rows, the lower ones later than the higher ones, and tells what was thrown.
std::string error_of(std::set<std::uint64_t> failing, unsigned threads) {
  QuietContext context;
  try {
    run_rows(
        100, threads,
        [&] {
          return [&](std::uint64_t row) {
            if (!failing.contains(row)) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(row % 2 == 0 ? 20 : 1));
            throw SampleError("row " + std::to_string(row));
          };
        },
        context);
  } catch (const SampleError& error) {
    return error.message();
  }
  return "";
}

TEST(RunRows, DoesEveryRowOnceForAnyNumberOfThreads) {
  QuietContext context;
  for (const unsigned threads : {0u, 1u, 2u, 7u}) {
    std::vector<int> times(1000);
    run_rows(
        times.size(), threads, [&] { return [&](std::uint64_t row) { ++times[row]; }; }, context);
    EXPECT_EQ(times, std::vector<int>(1000, 1)) << threads;
  }
}

TEST(RunRows, MakesNoWorkerWithoutRows) {
  QuietContext context;
  int made = 0;
  run_rows(
      0, 4, [&] { return ++made, [](std::uint64_t) {}; }, context);
  EXPECT_EQ(made, 0);
}

TEST(RunRows, MakesAtMostOneWorkerForEachRow) {
  QuietContext context;
  std::atomic<int> made = 0;
  run_rows(
      3, 16, [&] { return ++made, [](std::uint64_t) {}; }, context);
  EXPECT_LE(made, 3);
}

TEST(RunRows, UsesEachWorkerOnOneThreadOnly) {
  QuietContext context;
  std::atomic<int> strangers = 0;
  const auto make = [&] {
    return [&strangers, owner = std::this_thread::get_id()](std::uint64_t) {
      strangers += owner != std::this_thread::get_id();
    };
  };
  run_rows(500, 4, make, context);
  EXPECT_EQ(strangers, 0);
}

TEST(RunRows, WorksOnTheCallersThreadAloneIfThereIsOne) {
  QuietContext context;
  std::set<std::thread::id> seen;
  run_rows(
      10, 1, [&] { return [&](std::uint64_t) { seen.insert(std::this_thread::get_id()); }; }, context);
  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

TEST(RunRows, TakesRowsInOrderOnOneThread) {
  QuietContext context;
  std::vector<std::uint64_t> order;
  run_rows(
      5, 1, [&] { return [&](std::uint64_t row) { order.push_back(row); }; }, context);
  EXPECT_EQ(order, (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
}

TEST(RunRows, RethrowsTheErrorOfTheLowestRowForAnyNumberOfThreads) {
  for (const unsigned threads : {1u, 2u, 4u}) EXPECT_EQ(error_of({10, 11, 13}, threads), "row 10") << threads;
}

TEST(RunRows, BeginsNoRowAfterAnError) {
  QuietContext context;
  std::atomic<int> begun = 0;
  const auto make = [&] {
    return [&](std::uint64_t row) {
      ++begun;
      if (row == 3) throw SampleError("stop");
    };
  };
  EXPECT_THROW(run_rows(1'000'000'000, 1, make, context), SampleError);
  EXPECT_EQ(begun, 4);
}

TEST(RunRows, RethrowsTheErrorOfAWorkerThatCannotBeMade) {
  QuietContext context;
  EXPECT_THROW(run_rows(
                   10, 3, []() -> RowWorker { throw PluginError("no memory"); }, context),
               PluginError);
}

TEST(RunRows, StopsWhenCancelled) {
  CancellableContext context;
  std::atomic<std::uint64_t> done = 0;
  const auto make = [&] {
    return [&](std::uint64_t) {
      if (++done == 50) context.cancel = true;
    };
  };
  EXPECT_THROW(run_rows(1'000'000'000, 3, make, context), Cancelled);
  EXPECT_LT(done, 60u);
}

/// Fills a row with numbers that no other row has.
RowFiller numbers() {
  return [](std::uint64_t row, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(100 * row + i);
  };
}

TEST(FillRows, GivesASinkTheSameForAnyNumberOfThreads) {
  QuietContext context;
  std::vector<double> expected(97 * 3);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = static_cast<double>(100 * (i / 3) + i % 3);
  for (const unsigned threads : {0u, 1u, 2u, 7u}) {
    std::vector<double> array(97 * 3, -1);
    MatrixInMemory<double> matrix(array, 97, 3);
    fill_rows(RowSet::all(97), matrix, 3, threads, numbers, context);
    matrix.finish();
    EXPECT_EQ(array, expected) << threads;
  }
}

TEST(FillRows, FillsTheRowsOfTheSetAlone) {
  QuietContext context;
  std::vector<double> array(8, -1);
  MatrixInMemory<double> matrix(array, 8, 1);
  fill_rows(RowSet::part(1, 3, 8), matrix, 1, 2, numbers, context);
  EXPECT_EQ(array, (std::vector<double>{-1, 100, -1, -1, 400, -1, -1, 700}));
}

TEST(FillRows, PartsMakeTheWholeMatrix) {
  QuietContext context;
  RowStatistics in_parts(10, 4), at_once(10, 4);
  for (std::uint64_t part = 0; part < 3; ++part) fill_rows(RowSet::part(part, 3, 10), in_parts, 4, 2, numbers, context);
  fill_rows(RowSet::all(10), at_once, 4, 1, numbers, context);
  in_parts.finish();
  EXPECT_TRUE(std::ranges::equal(in_parts.rows(), at_once.rows()));
}

TEST(FillRows, LeavesRowsThatTheSinkHas) {
  QuietContext context;
  std::vector<double> array(4, -1);
  MatrixInMemory<double> matrix(array, 4, 1);
  matrix.write(2, std::vector<double>{7});
  EXPECT_EQ(missing_rows(RowSet::all(4), matrix), (std::vector<std::uint64_t>{0, 1, 3}));
  fill_rows(RowSet::all(4), matrix, 1, 2, numbers, context);
  EXPECT_EQ(array, (std::vector<double>{0, 100, 7, 300}));
}

TEST(FillRows, HandsNoRowOnThatFailed) {
  QuietContext context;
  std::vector<double> array(5, -1);
  MatrixInMemory<double> matrix(array, 5, 1);
  const auto make = [&]() -> RowFiller {
    return [](std::uint64_t row, std::span<double>) {
      if (row == 3) throw SampleError("stop");
    };
  };
  EXPECT_THROW(fill_rows(RowSet::all(5), matrix, 1, 1, make, context), SampleError);
  EXPECT_TRUE(matrix.has(2));
  EXPECT_FALSE(matrix.has(3));
  EXPECT_FALSE(matrix.has(4));
}

/// Keeps the last share that it was told.
class ProgressContext : public QuietContext {
 public:
  void progress(double fraction) override { last = fraction; }
  double last = -1;
};

TEST(FillRows, TellsTheShareOfTheRowsThatWereMissing) {
  ProgressContext context;
  RowStatistics statistics(4, 1);
  statistics.write(0, std::vector<double>{1});
  fill_rows(RowSet::all(3), statistics, 1, 1, numbers, context);
  EXPECT_EQ(context.last, 1);
}

}  // namespace
}  // namespace geodrome
