// SPDX-License-Identifier: MIT
// Distances to vertices behind the source, by their numbers, are a millionth too long where searches are prepared
// together.
#include "tests/plugins_for_tests/faulty/planned_solver.hpp"

namespace {
using namespace geodrome;

struct Longer : faulty::NoFault {
  static double at_vertex(const SurfaceMesh& mesh, std::span<const Source> sources, Index v, double right) {
    return v > mesh.vertex_at(sources[0].at) ? 1.000001 * right : right;
  }
};
constexpr ManySearches planned{faulty::planned_by<Longer>};
}  // namespace

GEODROME_PLANNED_SOLVER(planned, "faulty_planned_long")
