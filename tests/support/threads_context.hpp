// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/run_context.hpp"

namespace geodrome::test {

/// Allows so many threads.
class ThreadsContext : public QuietContext {
 public:
  explicit ThreadsContext(unsigned count) : count_(count) {}
  unsigned threads() const noexcept override { return count_; }

 private:
  unsigned count_;
};

}  // namespace geodrome::test
