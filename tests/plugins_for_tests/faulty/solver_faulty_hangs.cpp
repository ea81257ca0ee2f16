// SPDX-License-Identifier: MIT
// Never ends on a mesh with a face without area.
#include <atomic>

#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static void before_run(const SurfaceMesh& mesh) {
    static std::atomic<bool> forever = true;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [p, q, r] = mesh.corners(f);
      while (norm(cross(q - p, r - p)) == 0 && forever) continue;
    }
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_hangs")
