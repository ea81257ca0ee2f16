// SPDX-License-Identifier: MIT
// Waits for ever in a static initialiser.
#include <unistd.h>

#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int {
  for (;;) pause();
}();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_hangs_at_load"))
