// SPDX-License-Identifier: MIT
// Gives no object and no reason.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_null_from_create"))
