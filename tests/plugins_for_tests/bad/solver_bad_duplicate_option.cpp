// SPDX-License-Identifier: MIT
// Declares an option twice.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

namespace {
constexpr geodrome::OptionSpec options[] = {geodrome::integer_option("k", "3", 1, 9, "", "first"),
                                            geodrome::integer_option("k", "4", 1, 9, "", "second")};
}

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_duplicate_option");
  plugin.options = options, plugin.option_count = 2;
  return plugin;
}())
