// SPDX-License-Identifier: MIT
// Built with another standard library.
#include "descriptor.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_build_tag");
  plugin.build_tag = "libother debug float";
  return plugin;
}())
