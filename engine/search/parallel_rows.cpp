// SPDX-License-Identifier: MIT
#include "engine/search/parallel_rows.hpp"

#include <atomic>

#include "interfaces/internal/shared_work.hpp"

namespace geodrome {

void run_rows(std::uint64_t count, unsigned threads, const MakeRowWorker& make_worker, const RunContext& context) {
  share_work(count, 1, threads, context,
             [&] { return [worker = make_worker()](std::uint64_t row, std::uint64_t) { worker(row); }; });
}

std::vector<std::uint64_t> missing_rows(const RowSet& rows, const RowSink& sink) {
  std::vector<std::uint64_t> missing;
  for (std::uint64_t i = 0; i < rows.size(); ++i)
    if (!sink.has(rows[i])) missing.push_back(rows[i]);
  return missing;
}

void fill_rows(const RowSet& rows, RowSink& sink, std::size_t columns, unsigned threads,
               const MakeRowFiller& make_filler, RunContext& context) {
  const std::vector<std::uint64_t> missing = missing_rows(rows, sink);
  std::atomic<std::uint64_t> done = 0;
  const auto make_worker = [&]() -> RowWorker {
    return [&, fill = make_filler(), values = std::vector<double>(columns)](std::uint64_t k) mutable {
      fill(missing[k], values);
      sink.write(missing[k], values);
      context.progress(static_cast<double>(++done) / static_cast<double>(missing.size()));
    };
  };
  run_rows(missing.size(), threads, make_worker, context);
}

}  // namespace geodrome
