// SPDX-License-Identifier: MIT
// Built with another standard library.
#include "tests/plugins_for_tests/bad/descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_build_tag");
  plugin.build_tag = "libother debug float";
  return plugin;
}())
