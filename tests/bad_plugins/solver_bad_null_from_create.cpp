// SPDX-License-Identifier: MIT
// Gives no object and no reason.
#include "straight_solver.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::bad::descriptor("bad_null_from_create");
  plugin.create = [](const geodrome::OptionValues*, const geodrome::ErrorSink*) noexcept -> void* { return nullptr; };
  return plugin;
}())
