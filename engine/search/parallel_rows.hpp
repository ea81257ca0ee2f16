// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "geodrome/run_context.hpp"

namespace geodrome {

/// Does one row; belongs to one thread and may keep that thread's working memory.
using RowWorker = std::function<void(std::uint64_t row)>;

/// Makes a worker. Called once on each thread that takes part, from several at the same time.
using MakeRowWorker = std::function<RowWorker()>;

/// Does rows 0 .. count - 1, each once, on at most `threads` threads (0 counts as 1; the caller's is one of them).
/// Threads take the rows in ascending order. Returns when all are done and every worker is gone.
///
/// After the first exception no further row is begun; rows begun are completed; then the exception of the lowest row
/// that failed is thrown, which is the same for any number of threads. Throws Cancelled once `context` says so.
void run_rows(std::uint64_t count, unsigned threads, const MakeRowWorker& make_worker, const RunContext& context);

}  // namespace geodrome
