// SPDX-License-Identifier: MIT
// Ends the process quietly, as if all were well.
#include <unistd.h>

#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int { _exit(0); }();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_exits_at_load"))
