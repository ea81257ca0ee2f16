// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "geodrome/control_function.hpp"

namespace geodrome {

/// Stage 3: a self-conforming subset of the sample (Definition 5, Algorithm 1).
class GEODROME_VISIBLE Decimator {
 public:
  static constexpr const char* stage = "decimator";
  virtual ~Decimator() = default;

  /// The indices kept (S_conf), ascending, without dropped points; not empty unless all are dropped. Thread-safe.
  virtual std::vector<Index> select(const PointSample& sample, const Control& control, RunContext& context) const = 0;
};

}  // namespace geodrome
