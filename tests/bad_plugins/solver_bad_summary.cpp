// SPDX-License-Identifier: MIT
// Has no summary.
#include "descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_summary");
  plugin.summary = nullptr;
  return plugin;
}())
