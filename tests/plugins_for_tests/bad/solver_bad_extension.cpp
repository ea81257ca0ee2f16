// SPDX-License-Identifier: MIT
// Answers to any extension, whatever its name.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_extension");
  plugin.extension = [](const char* id) noexcept -> const void* { return id; };
  return plugin;
}())
