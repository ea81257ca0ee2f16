// SPDX-License-Identifier: MIT
// Built for an interface version that is not accepted any more.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_old_version");
  plugin.interface_version = geodrome::oldest_interface_version - 1;
  return plugin;
}())
