// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/decimator.hpp"

namespace geodrome {

/// Keeps every point that is not dropped: the sample is used as it is, and need not be self-conforming.
class NoDecimation final : public Decimator {
 public:
  std::vector<Index> select(const PointSample& sample, const Control& control, RunContext& context) const override;
};

}  // namespace geodrome
