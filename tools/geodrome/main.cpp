// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "commands.hpp"
#include "geodrome/engine/boundary.hpp"
#include "geodrome/engine/version.hpp"

namespace {

constexpr const char* footer =
    "Indices count from 0. Unreachable is inf, dropped nan.\n"
    "Exit status: 0 done, 1 internal error, 2 usage, 3 bad input, unwritable output, or a plugin's needs or provides "
    "not met,\n"
    "4 refused (disk, --yes, sample or surface not fit), 5 plugin failure, 130 cancelled.\n"
    "'geodrome COMMAND --help' tells the options of a command.";

/// CLI11 reports through exceptions and statuses of its own: help and version are 0, every mistake is usage.
int parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? -1 : 2;
  }
}

int run(int argc, char** argv) {
  CLI::App app("Geodesic distances on surfaces: points or a mesh in, distances out, every stage a plugin", "geodrome");
  app.set_version_flag("--version", std::string("geodrome ") + geodrome::version());
  app.require_subcommand(1);
  app.footer(footer);
  geodrome::cli::Action action;
  using namespace geodrome::cli;
  for (const auto add : {add_distances, add_surface, add_path, add_check, add_plugins, add_compare, add_shape})
    add(app, action);
  const int status = parse(app, argc, argv);
  if (status != 0) return status < 0 ? 0 : status;
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  geodrome::install_crash_handlers();
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "geodrome: %s\n", error.what());
    return geodrome::exit_status(error);
  }
}
