// SPDX-License-Identifier: MIT
// Paths lack their last step: they are shorter than their distance.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static void path(std::vector<SurfacePoint>& path) {
    if (path.size() > 1) path.pop_back();
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_short_paths")
