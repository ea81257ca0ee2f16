// SPDX-License-Identifier: MIT
// geodrome-faults [--all] [--seed N] [--only KIND.JOB] [--program FILE]: tries faults of the machine on the program.
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>

#include "tests/faults/campaign.hpp"
#include "tests/faults/jobs.hpp"

namespace {

using namespace geodrome::faults;

struct Options {
  bool all = false;
  std::uint64_t seed = 1;
  std::string only, program = GEODROME_BINARY_DIR "/bin/geodrome";
};

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 == argc) throw std::runtime_error(word + " lacks its value");
      return argv[++i];
    };
    if (word == "--all")
      options.all = true;
    else if (word == "--seed")
      options.seed = std::stoull(value());
    else if (word == "--only")
      options.only = value();
    else if (word == "--program")
      options.program = value();
    else
      throw std::runtime_error("unknown option " + word);
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = options_of(argc, argv);
    Lab lab(options.program);
    std::vector<Job> jobs = make_jobs(lab);
    Campaign campaign(lab, std::move(jobs), options.all, options.seed, options.only);
    for (const auto attempt : {try_calls, try_changes, try_signals, try_memory, try_places}) attempt(campaign);
    return campaign.report() == 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "geodrome-faults: %s\n", error.what());
    return 2;
  }
}
