// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace geodrome::bench {

/// Runs `work` in a child process, so that peaks of memory do not mix; prints how it ended if not well. Call it before
/// a thread was started. Throws RefusedError if there can be no child.
void in_a_process_of_its_own(const std::function<void()>& work);

}  // namespace geodrome::bench
