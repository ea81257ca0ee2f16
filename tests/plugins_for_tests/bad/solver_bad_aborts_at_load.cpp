// SPDX-License-Identifier: MIT
// Aborts in a static initialiser.
#include <cstdio>
#include <cstdlib>

#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int {
  std::fputs("bad_aborts_at_load: lookup table is corrupt\n", stderr);
  std::abort();
}();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_aborts_at_load"))
