// SPDX-License-Identifier: MIT
// Needs something that no host knows.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_needs");
  plugin.needs = geodrome::Needs{std::uint64_t{1} << 40};
  return plugin;
}())
