// SPDX-License-Identifier: MIT
// Writes through a null pointer in a static initialiser.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
  return 1;
}();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_crashes_at_load"))
