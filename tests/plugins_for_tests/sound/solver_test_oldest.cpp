// SPDX-License-Identifier: MIT
// Built for the oldest interface version that is accepted, with the short descriptor of that time. What lies behind the
// descriptor's end would abort the process if the host took it for a member.
#include <cstdlib>

#include "tests/plugins_for_tests/bad/descriptor.hpp"
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

GEODROME_BAD_ENTRY([] {
  auto plugin = geodrome::detail::describe<geodrome::bad::StraightSolver<>>(
      {.name = "test_oldest", .summary = "straight through space", .licence = "MIT"});
  plugin.size = geodrome::smallest_descriptor;
  plugin.interface_version = geodrome::oldest_interface_version;
  plugin.extension = [](const char*) noexcept -> const void* { std::abort(); };
  return plugin;
}())
