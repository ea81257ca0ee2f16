// SPDX-License-Identifier: MIT
#include "engine/search/parallel_rows.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace geodrome {
namespace {

/// What the threads share.
class RowQueue {
 public:
  RowQueue(std::uint64_t count, const RunContext& context) : count_(count), context_(context) {}

  /// One thread's part of the work. Never throws: what goes wrong is kept for `rethrow`.
  void work(const MakeRowWorker& make_worker) noexcept {
    std::uint64_t order = 0;  // a worker that cannot be made comes before every row
    try {
      const RowWorker worker = make_worker();
      while (!stopped_) {
        const std::uint64_t row = next_++;
        if (row >= count_) return;
        order = row + 1;
        context_.throw_if_cancelled();
        worker(row);
      }
    } catch (...) {
      keep(order, std::current_exception());
    }
  }

  void rethrow() {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  // Rows are taken in ascending order and completed once taken, so every row below a failed one is tried: the lowest
  // failed row does not depend on the timing.
  void keep(std::uint64_t order, std::exception_ptr error) {
    stopped_ = true;
    const std::lock_guard lock(mutex_);
    if (order >= error_order_) return;
    error_order_ = order;
    error_ = std::move(error);
  }

  const std::uint64_t count_;
  const RunContext& context_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::uint64_t error_order_ = std::numeric_limits<std::uint64_t>::max();
  std::exception_ptr error_;
};

}  // namespace

void run_rows(std::uint64_t count, unsigned threads, const MakeRowWorker& make_worker, const RunContext& context) {
  if (count == 0) return;
  RowQueue queue(count, context);
  {
    std::vector<std::jthread> helpers;
    const std::uint64_t wanted = std::min<std::uint64_t>(count, std::max(threads, 1u)) - 1;
    try {
      for (std::uint64_t i = 0; i < wanted; ++i) helpers.emplace_back([&] { queue.work(make_worker); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do the same work.
    }
    queue.work(make_worker);
  }
  queue.rethrow();
}

}  // namespace geodrome
