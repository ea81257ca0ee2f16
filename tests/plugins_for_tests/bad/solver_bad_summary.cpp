// SPDX-License-Identifier: MIT
// Has no summary.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_summary");
  plugin.summary = nullptr;
  return plugin;
}())
