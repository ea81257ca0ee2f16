// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

/// Resident memory of this process, now and at most, as Linux counts it: to within some hundred kilobytes.
namespace geodrome {

/// Bytes; since the process began, or since the last reset. 0 where /proc does not tell.
std::size_t memory_peak();

/// Bytes; 0 where /proc does not tell.
std::size_t memory_now();

/// Makes what is resident now the peak. False where the system does not allow it: the peak then only grows.
bool reset_memory_peak();

/// Makes the code of all libraries resident, so that what a plugin adds from then on is data.
void make_code_resident();

}  // namespace geodrome
