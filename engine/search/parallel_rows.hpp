// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geodrome/engine/row_set.hpp"
#include "geodrome/engine/row_sink.hpp"
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

/// Fills one row; belongs to one thread, as RowWorker.
using RowFiller = std::function<void(std::uint64_t row, std::span<double> values)>;

/// Makes a filler, as MakeRowWorker.
using MakeRowFiller = std::function<RowFiller()>;

/// The rows of the set that the sink has not, ascending. O(rows).
std::vector<std::uint64_t> missing_rows(const RowSet& rows, const RowSink& sink);

/// Fills the rows of the set that the sink has not, each once, and hands them to the sink, as `run_rows` does; tells
/// `context` the share that is done. What the sink gets does not depend on the number of threads if the fillers'
/// results do not. Does not finish the sink. Memory: a row of `columns` numbers per thread, and O(rows).
void fill_rows(const RowSet& rows, RowSink& sink, std::size_t columns, unsigned threads,
               const MakeRowFiller& make_filler, RunContext& context);

}  // namespace geodrome
