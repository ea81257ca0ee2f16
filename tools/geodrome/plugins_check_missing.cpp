// SPDX-License-Identifier: MIT
#include "tools/geodrome/commands.hpp"

namespace geodrome::cli {

/// Stands for the command in a build without the conformance kit.
void add_plugins_check(CLI::App& plugins, Action& action) {
  CLI::App& command = *plugins.add_subcommand("check", "Left out of this build, as is the conformance kit");
  command.allow_extras();
  command.callback([&action] {
    action = []() -> int {
      throw OptionError("'plugins check' was left out of this build", "configure with -DGEODROME_BUILD_CONFORMANCE=ON");
    };
  });
}

}  // namespace geodrome::cli
