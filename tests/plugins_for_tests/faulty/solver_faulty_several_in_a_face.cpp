// SPDX-License-Identifier: MIT
// Too long at the second corner of a face that two sources lie inside: a window that is lost while they compete.
#include <algorithm>

#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static double at_vertex(const SurfaceMesh& mesh, std::span<const Source> sources, Index vertex, double right) {
    const auto lies_inside = [&](const Source& source) {
      return mesh.triangles()[source.at.face][1] == vertex && *std::ranges::min_element(source.at.b) > 0;
    };
    return std::ranges::count_if(sources, lies_inside) > 1 ? 1.3 * right : right;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_several_in_a_face")
