// SPDX-License-Identifier: MIT
// Writes through a null pointer where an edge has more than two faces.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static void before_run(const SurfaceMesh& mesh) {
    static int somewhere = 0;
    int* volatile place = mesh.manifold() ? &somewhere : nullptr;
    *place = 1;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_crashes")
