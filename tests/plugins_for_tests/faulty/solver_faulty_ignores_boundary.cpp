// SPDX-License-Identifier: MIT
// Closes every hole with a fan of faces, over which paths then lead.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  /// The boundary half-edge that goes on where `h` ends.
  static Index next_on_boundary(const SurfaceMesh& mesh, Index h) {
    Index next = SurfaceMesh::next(h);
    while (mesh.twins()[next] != no_index) next = SurfaceMesh::next(mesh.twins()[next]);
    return next;
  }

  static MeshPtr mesh(MeshPtr open) {
    if (!open->manifold() || !open->oriented()) return open;
    std::vector<Vec3> positions(open->positions().begin(), open->positions().end());
    std::vector<Triangle> triangles(open->triangles().begin(), open->triangles().end());
    std::vector<bool> done(open->twins().size());
    for (Index first = 0; first < done.size(); ++first) {
      if (done[first] || open->twins()[first] != no_index) continue;
      Vec3 sum;
      std::size_t count = 0;
      const auto centre = static_cast<Index>(positions.size());
      for (Index h = first; !done[h]; h = next_on_boundary(*open, h)) {
        done[h] = true, sum = sum + open->positions()[open->from(h)], ++count;
        triangles.push_back({open->to(h), open->from(h), centre});
      }
      positions.push_back(sum / static_cast<double>(count));
    }
    return std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles));
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_ignores_boundary")
