// SPDX-License-Identifier: MIT
// A good plugin that prints what looks like an answer while it is loaded.
#include <cstdio>

#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int {
  std::puts("{\"plugin\":{\"name\":\"forged\"}}");
  std::fflush(stdout);
  return 1;
}();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("test_noisy"))
