// SPDX-License-Identifier: MIT
// Gives no object and no reason.
#include "descriptor.hpp"

GEODROME_BAD_ENTRY(geodrome::bad::descriptor("bad_null_from_create"))
