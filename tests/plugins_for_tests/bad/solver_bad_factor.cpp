// SPDX-License-Identifier: MIT
// Promises distances shorter than the shortest.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_factor");
  plugin.factor = [](const geodrome::OptionValues*) noexcept { return 0.5; };
  return plugin;
}())
