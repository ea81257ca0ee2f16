// SPDX-License-Identifier: MIT
// What cannot be reached is at distance 0.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static double value(double right) { return std::isfinite(right) ? right : 0; }
  static Distance at(const ShortestPathMap&, const SurfaceMesh&, const SurfacePoint&, Distance right) {
    return right.reach == Reach::unreachable ? Distance{0, Reach::reached, 0} : right;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_zero_unreachable")
