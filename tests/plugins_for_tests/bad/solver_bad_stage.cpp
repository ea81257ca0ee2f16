// SPDX-License-Identifier: MIT
// Claims a stage that does not exist.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_stage");
  plugin.stage = "teleporter";
  return plugin;
}())
