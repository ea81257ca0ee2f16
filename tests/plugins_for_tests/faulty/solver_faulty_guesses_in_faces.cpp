// SPDX-License-Identifier: MIT
// Inside faces it interpolates between the corners.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static Distance at(const ShortestPathMap& map, const SurfaceMesh& mesh, const SurfacePoint& point, Distance right) {
    double guess = 0;
    for (int i = 0; i < 3; ++i)
      if (point.b[i] > 0) guess += point.b[i] * map.vertices()[mesh.triangles()[point.face][i]];
    return right.reach == Reach::reached ? Distance{guess, right.reach, right.source} : right;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_guesses_in_faces")
