// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "geodrome/engine/boundary.hpp"
#include "geodrome/engine/version.hpp"
#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"
#include "tools/geodrome/remedies.hpp"

namespace {

constexpr const char* footer =
    "Indices count from 0. Unreachable is inf, dropped or off the part nan.\n"
    "Exit status: 0 done, 1 internal error, 2 usage, 3 bad input, unwritable output, or a plugin's needs or provides "
    "not met,\n"
    "4 refused (disk, memory, --yes, sample or surface not fit, a plugin by 'plugins check'), 5 plugin failure or "
    "distances that broke a promise, 130 cancelled.\n"
    "'geodrome COMMAND --help' tells the options of a command.";

/// A standard stream that the caller has closed is replaced by one that cannot be used: the next file that is opened
/// would take its number, and messages would be written into that file.
void occupy_standard_streams() {
  for (int descriptor = 0; descriptor <= 2;) {
    descriptor = open("/dev/null", O_RDONLY);
    if (descriptor > 2) close(descriptor);
    if (descriptor < 0) return;
  }
}

/// A limit of file sizes and a reader that went away then show as errors of writing, which are told, and do not end a
/// job of hours.
void take_signals_of_writing_as_errors() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

/// CLI11 takes a word that is no command for a missing one.
void demand_known_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
    names.push_back(command->get_name());
  }
  throw geodrome::OptionError("there is no command '" + std::string(argv[1]) + "'",
                              "choose one of " + geodrome::cli::joined(names));
}

/// CLI11 reports through exceptions and statuses of its own: help and version are 0, every mistake is usage.
int parse(CLI::App& app, int argc, char** argv) {
  demand_known_command(app, argc, argv);
  try {
    std::vector<std::string> words(argv + 1, argv + argc);
    geodrome::cli::fill_in_values(words);
    std::ranges::reverse(words);  // as CLI11 wants them
    app.parse(std::move(words));
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
  for (const auto add :
       {add_distances, add_queries, add_surface, add_path, add_check, add_plugins, add_compare, add_shape})
    add(app, action);
  const int status = parse(app, argc, argv);
  if (status > 0) return status;
  const int done = status < 0 ? 0 : action();
  std::cout.flush();
  if (!std::cout)
    throw geodrome::InputError(geodrome::InputFault::io, "standard output cannot be written",
                               "check where it leads; files that were asked for are complete");
  return done;
}

/// Comes before the objects of libraries that are made before main: their memory may not suffice either.
[[gnu::constructor(101)]] void install_first() { geodrome::install_crash_handlers(); }

}  // namespace

int main(int argc, char** argv) {
  occupy_standard_streams();
  take_signals_of_writing_as_errors();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc& error) {
    std::fprintf(stderr, "geodrome: out of memory; %s\n", geodrome::out_of_memory_remedy);
    return geodrome::exit_status(error);
  } catch (const geodrome::Error& error) {
    std::fprintf(stderr, "geodrome: %s\n", geodrome::cli::text_of(error).c_str());
    return geodrome::exit_status(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "geodrome: %s\n", error.what());
    return geodrome::exit_status(error);
  }
}
