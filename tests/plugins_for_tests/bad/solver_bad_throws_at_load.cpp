// SPDX-License-Identifier: MIT
// Throws in a static initialiser.
#include <stdexcept>

#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
const int at_load = []() -> int { throw std::runtime_error("the licence server is down"); }();
}  // namespace

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_throws_at_load"))
