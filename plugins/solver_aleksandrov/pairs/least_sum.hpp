// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace geodrome::aleksandrov {

/// The least a[i] + b[i] for i < count, infinity if there is none. The same on every processor.
float least_sum(const float* a, const float* b, std::size_t count);

}  // namespace geodrome::aleksandrov
