// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

#include "geodrome/run_context.hpp"

namespace geodrome {

/// The part of a stage's progress that one loop makes up.
struct ProgressShare {
  double from = 0, to = 1;
};

/// Calls `body(begin, end)` for consecutive chunks that cover [0, count), on up to `context.threads()` threads. `body`
/// must be safe to run at once on different chunks, and write only what belongs to its own chunk: then the result does
/// not depend on the number of threads. Throws what `body` throws, from the lowest chunk that fails, whatever the
/// number of threads; Cancelled between two chunks. Reports progress from the calling thread only, never backwards.
void parallel_for(std::size_t count, RunContext& context, ProgressShare share,
                  const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace geodrome
