// SPDX-License-Identifier: MIT
// The default of an option is out of its own range.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
constexpr geodrome::OptionSpec options[] = {geodrome::integer_option("k", "30", 1, 9, "", "neighbours")};
}

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_default");
  plugin.options = options, plugin.option_count = 1;
  return plugin;
}())
