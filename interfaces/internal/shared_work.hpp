// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "geodrome/run_context.hpp"

/// The one loop over threads of engine and plugins. Not installed.
namespace geodrome {

namespace detail {

/// What the threads share: the next item to take, and the failure of the lowest one.
class WorkQueue {
 public:
  WorkQueue(std::uint64_t count, std::uint64_t chunk, const RunContext& context)
      : count_(count), chunk_(chunk), context_(context) {}

  /// Does one thread's part of the work. Never throws: the failure is kept for `rethrow`.
  template <class MakeWorker>
  void work(const MakeWorker& make_worker) noexcept {
    std::uint64_t order = 0;  // a worker that cannot be made comes before every item
    try {
      auto worker = make_worker();
      while (!stopped_) {
        const std::uint64_t begin = next_.fetch_add(chunk_);
        if (begin >= count_) return;
        order = begin + 1;
        context_.throw_if_cancelled();
        worker(begin, std::min(begin + chunk_, count_));
      }
    } catch (...) {
      keep(order, std::current_exception());
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  // Chunks are taken in ascending order and completed once taken, so every chunk below a failed one is tried: the
  // lowest failure does not depend on the timing.
  void keep(std::uint64_t order, std::exception_ptr error) {
    stopped_ = true;
    const std::lock_guard lock(mutex_);
    if (order >= error_order_) return;
    error_order_ = order;
    error_ = std::move(error);
  }

  const std::uint64_t count_, chunk_;
  const RunContext& context_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::mutex mutex_;
  std::uint64_t error_order_ = std::numeric_limits<std::uint64_t>::max();
  std::exception_ptr error_;
};

}  // namespace detail

/// Does the items 0 .. count - 1, each once, on at most `threads` threads (0 counts as 1; the caller's is one of them).
/// Each thread calls `make_worker()` once, several at the same time, then its worker as `worker(begin, end)` for chunks
/// of `chunk` consecutive items (the last one may be shorter), which are handed out in ascending order. Returns when
/// all are done and every worker is gone. Precondition: chunk > 0, count + threads * chunk fits into 64 bits.
///
/// After the first exception no further chunk is begun; chunks begun are completed; then the exception of the lowest
/// chunk that failed is thrown, which is the same for any number of threads. Throws Cancelled once `context` says so.
template <class MakeWorker>
void share_work(std::uint64_t count, std::uint64_t chunk, unsigned threads, const RunContext& context,
                const MakeWorker& make_worker) {
  if (count == 0) return;
  detail::WorkQueue queue(count, chunk, context);
  {
    std::vector<std::jthread> helpers;
    const std::uint64_t chunks = (count - 1) / chunk + 1;
    const std::uint64_t wanted = std::min<std::uint64_t>(chunks, std::max(threads, 1U)) - 1;
    try {
      for (std::uint64_t i = 0; i < wanted; ++i) helpers.emplace_back([&] { queue.work(make_worker); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do the same work.
    } catch (const std::bad_alloc&) {
      // Nor memory for them.
    }
    queue.work(make_worker);
  }
  queue.rethrow();
}

}  // namespace geodrome
