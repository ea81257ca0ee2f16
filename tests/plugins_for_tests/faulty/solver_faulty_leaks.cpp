// SPDX-License-Identifier: MIT
// Every search leaves a few bytes behind.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static void before_run(const SurfaceMesh&) {
    [[maybe_unused]] static char* volatile last = nullptr;
    last = new char[64];
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_leaks")
