// SPDX-License-Identifier: MIT
// Has a name that nobody could write on a command line.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_name");
  plugin.name = "Bad Name";
  return plugin;
}())
