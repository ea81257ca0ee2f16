// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace geodrome::bench {

/// What a child process took, with those that it waited for.
struct ProcessCost {
  bool well = false;           ///< it ended without an error
  double seconds = 0;          ///< of processors, in the program and in the system
  std::size_t peak_bytes = 0;  ///< resident; at least what the parent had
};

/// Runs `work` in a child process, so that peaks of memory do not mix; prints how it ended if not well. Call it before
/// a thread was started. Throws RefusedError if there can be no child.
ProcessCost in_a_process_of_its_own(const std::function<void()>& work);

}  // namespace geodrome::bench
