// SPDX-License-Identifier: MIT
// Its descriptor lacks a member that every accepted version has.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_size");
  plugin.size = geodrome::smallest_descriptor - sizeof(void*);
  return plugin;
}())
