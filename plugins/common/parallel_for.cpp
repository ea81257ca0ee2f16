// SPDX-License-Identifier: MIT
#include "plugins/common/parallel_for.hpp"

#include <atomic>
#include <thread>

#include "interfaces/internal/shared_work.hpp"

namespace geodrome {
namespace {

/// Chunks are small enough to share the work evenly, and large enough that taking one costs nothing.
constexpr std::size_t chunk_size = 512;

}  // namespace

void parallel_for(std::size_t count, RunContext& context, ProgressShare share,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  context.throw_if_cancelled();
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> items_done = 0;
  const auto make_worker = [&] {
    return [&, reports_progress = std::this_thread::get_id() == caller](std::size_t begin, std::size_t end) {
      body(begin, end);
      const std::size_t done = items_done += end - begin;
      if (!reports_progress) return;
      const double part = static_cast<double>(done) / static_cast<double>(count);
      context.progress(share.from + (share.to - share.from) * part);
    };
  };
  share_work(count, chunk_size, context.threads(), context, make_worker);
  context.progress(share.to);
}

}  // namespace geodrome
