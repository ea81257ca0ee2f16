// SPDX-License-Identifier: MIT
// The default of an option is a number with a comma behind it.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
constexpr geodrome::OptionSpec options[] = {geodrome::number_option("delta", "0.1,", 0, 1, "", "accuracy")};
}

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_comma");
  plugin.options = options, plugin.option_count = 1;
  return plugin;
}())
