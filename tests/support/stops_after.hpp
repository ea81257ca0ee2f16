// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/run_context.hpp"

namespace geodrome::test {

/// Asked `polls` times, it says stop.
class StopsAfter : public QuietContext {
 public:
  explicit StopsAfter(int polls) : left_(polls) {}
  bool cancelled() const noexcept override { return left_-- <= 0; }

 private:
  mutable int left_;
};

}  // namespace geodrome::test
