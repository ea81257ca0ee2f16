// SPDX-License-Identifier: MIT
#include "plugins/common/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace geodrome {
namespace {

class Context : public QuietContext {
 public:
  explicit Context(unsigned threads) : threads_(threads) {}
  void progress(double fraction) override { reported.push_back(fraction); }
  bool cancelled() const noexcept override { return stop; }
  unsigned threads() const noexcept override { return threads_; }

  std::vector<double> reported;
  std::atomic<bool> stop = false;

 private:
  unsigned threads_;
};

TEST(ParallelFor, VisitsEveryElementOnce) {
  for (const unsigned threads : {1U, 2U, 7U})
    for (const std::size_t count : {0, 1, 511, 512, 513, 5000}) {
      Context context(threads);
      std::vector<int> visits(count, 0);
      parallel_for(count, context, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      EXPECT_EQ(visits, std::vector<int>(count, 1)) << threads << " threads, " << count;
    }
}

TEST(ParallelFor, ThrowsTheErrorOfTheLowestChunk) {
  for (int trial = 0; trial < 20; ++trial) {
    Context context(4);
    std::string message;
    try {
      parallel_for(20000, context, {}, [](std::size_t begin, std::size_t end) {
        if (end > 3000) throw std::runtime_error(std::to_string(begin));
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "2560");
  }
}

TEST(ParallelFor, StopsWhenCancelled) {
  Context context(2);
  std::atomic<int> chunks = 0;
  EXPECT_THROW(parallel_for(1000000, context, {},
                            [&](std::size_t, std::size_t) {
                              ++chunks;
                              context.stop = true;
                            }),
               Cancelled);
  EXPECT_LE(chunks, 2);
}

TEST(ParallelFor, ProgressRisesToTheEndOfItsShare) {
  Context context(3);
  parallel_for(10000, context, {0.25, 0.75}, [](std::size_t, std::size_t) {});
  EXPECT_TRUE(std::is_sorted(context.reported.begin(), context.reported.end()));
  EXPECT_GE(context.reported.front(), 0.25);
  EXPECT_EQ(context.reported.back(), 0.75);
}

}  // namespace
}  // namespace geodrome
