// SPDX-License-Identifier: MIT
// geodrome-judge PLUGIN.so[:key=value,...] DEMAND MEGABYTES [--plugin-path DIR]... [--mesh FILE]...
//
// Judges one demand on one plugin and prints the verdict as one JSON object to standard output, status 0. Whatever the
// plugin does to the process stays in this process; who runs it sets a time limit and takes any other end for a
// failure.
#include <sys/prctl.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <iostream>

#include "engine/host/answer.hpp"
#include "engine/host/crashes_are_signals.hpp"
#include "tools/conformance/verdict_json.hpp"

namespace {

using namespace geodrome;
using namespace geodrome::conformance;

/// Memory without end is to end here, and not with the machine.
void limit_memory(const char* megabytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // these reserve terabytes of address space
  const rlim_t bytes = std::strtoull(megabytes, nullptr, 10) << 20;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
#else
  (void)megabytes;
#endif
}

Subject subject_of(int argc, char** argv) {
  std::vector<std::filesystem::path> folders, meshes;
  for (int i = 4; i + 1 < argc; i += 2)
    (std::string_view(argv[i]) == "--mesh" ? meshes : folders).emplace_back(argv[i + 1]);
  Subject subject = find_subject(argv[1], folders);
  subject.meshes = std::move(meshes);
  return subject;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr
        << "usage: geodrome-judge PLUGIN.so[:key=value,...] DEMAND MEGABYTES [--plugin-path DIR]... [--mesh FILE]...\n";
    return 2;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a plugin that hangs must not outlive who asked
  const Answer answer("geodrome-judge");
  try {
    const Subject subject = subject_of(argc, argv);
    limit_memory(argv[3]);
    answer.end(to_json(judge(subject, argv[2])).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), 0);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
