// SPDX-License-Identifier: MIT
// With several sources one vertex in seven is a little too far away.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static double at_vertex(const SurfaceMesh&, std::span<const Source> sources, Index vertex, double right) {
    return sources.size() > 1 && vertex % 7 == 1 ? 1.001 * right : right;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_several_sources")
