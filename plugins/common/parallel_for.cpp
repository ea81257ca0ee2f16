// SPDX-License-Identifier: MIT
#include "plugins/common/parallel_for.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace geodrome {
namespace {

/// Is small enough to share the work evenly, and large enough that taking a chunk costs nothing.
constexpr std::size_t chunk_size = 512;

class Loop {
 public:
  Loop(std::size_t count, RunContext& context, ProgressShare share,
       const std::function<void(std::size_t, std::size_t)>& body)
      : count_(count), context_(context), share_(share), body_(body) {}

  // Chunks are taken in ascending order, and a chunk that was taken is finished. So all chunks below a failed one were
  // run, and the lowest failure is the same for any number of threads.
  void work(bool reports_progress) noexcept {
    while (!stop_) {
      const std::size_t begin = next_.fetch_add(chunk_size);
      if (begin >= count_) return;
      const std::size_t end = std::min(begin + chunk_size, count_);
      try {
        context_.throw_if_cancelled();
        body_(begin, end);
        const std::size_t done = done_ += end - begin;
        if (reports_progress)
          context_.progress(share_.from +
                            (share_.to - share_.from) * static_cast<double>(done) / static_cast<double>(count_));
      } catch (...) {
        fail(begin);
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void fail(std::size_t begin) {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
    if (begin >= failed_at_) return;
    failed_at_ = begin;
    error_ = std::current_exception();
  }

  const std::size_t count_;
  RunContext& context_;
  const ProgressShare share_;
  const std::function<void(std::size_t, std::size_t)>& body_;
  std::atomic<std::size_t> next_ = 0, done_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::size_t failed_at_ = std::numeric_limits<std::size_t>::max();
  std::exception_ptr error_;
};

}  // namespace

void parallel_for(std::size_t count, RunContext& context, ProgressShare share,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  context.throw_if_cancelled();
  Loop loop(count, context, share, body);
  {
    const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min<std::size_t>(context.threads(), chunks); ++i)
      helpers.emplace_back([&loop] { loop.work(false); });
    loop.work(true);
  }
  loop.rethrow();
  context.progress(share.to);
}

}  // namespace geodrome
