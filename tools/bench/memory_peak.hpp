// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// The largest resident memory of this process, as Linux counts it.
namespace geodrome::bench {

/// Bytes; since the process began, or since the last reset. 0 where /proc does not tell.
std::size_t memory_peak();

/// Makes what is resident now the peak. False where the system does not allow it: the peak then only grows.
bool reset_memory_peak();

}  // namespace geodrome::bench
