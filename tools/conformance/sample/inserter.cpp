// SPDX-License-Identifier: MIT
// Every reconstructor that can insert points: what PointInserter promises.
#include <algorithm>

#include "tools/conformance/sample/reconstructor_trial.hpp"

namespace geodrome::conformance {
namespace {

Vec3 torus_point(double u, double v) {
  const double r = 1 + 0.4 * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
}

Vec3 torus_normal(const Vec3& p) {
  const double ring = std::hypot(p.x, p.y);
  const Vec3 out = p - Vec3{p.x / ring, p.y / ring, 0};
  return out / norm(out);
}

/// A torus: points that are kept, and 60 random ones that are not.
Staged torus_with_others() {
  Staged s;
  const MeshPtr mesh = bumpy_torus(60, 24, 0.01, 3);
  s.sample.points.assign(mesh->positions().begin(), mesh->positions().end());
  for (Index i = 0; i < s.sample.size(); ++i) s.kept.push_back(i);
  Random random(8);
  for (int i = 0; i < 60; ++i) {
    const double u = random.uniform(0, 2 * std::numbers::pi), v = random.uniform(0, 2 * std::numbers::pi);
    s.sample.points.push_back(torus_point(u, v));
  }
  for (const Vec3& p : s.sample.points) s.tangents.plane.push_back({p, torus_normal(p), 0});
  s.tangents.state.assign(s.sample.size(), PointState::ok);
  s.control.psi.assign(s.sample.size(), 0.15);  // the mesh's edges are 0.06 to 0.2 long
  s.control.phi = s.control.psi;
  s.control.state = s.tangents.state;
  return s;
}

Reconstruction with_inserter(ReconstructorTrial& t, const Staged& s) {
  try {
    Reconstruction made = t.reconstruct(s);
    if (made.inserter) return made;
  } catch (const SampleError& refusal) {
    throw NotApplicable{std::string("the torus is refused: ") + refusal.what()};
  }
  throw NotApplicable{"the reconstructor cannot insert points"};
}

void own_vertices(ReconstructorTrial& t) {
  const Staged s = torus_with_others();
  const Reconstruction made = with_inserter(t, s);
  for (Index v = 0; v < made.mesh->vertex_count(); v += 17) {
    const Inserted got = made.inserter->with(made.sample_of_vertex[v]);
    t.holds(got.mesh == made.mesh && got.how == Insertion::existing, "the reconstruction itself", "vertex ", v);
    t.equal(got.vertex, v);
  }
}

void other_points(ReconstructorTrial& t) {
  const Staged s = torus_with_others();
  const Reconstruction made = with_inserter(t, s);
  for (Index point = static_cast<Index>(s.kept.size()); point < s.sample.size(); ++point) {
    const Inserted got = made.inserter->with(point);
    const SurfaceMesh &mesh = *got.mesh, &old = *made.mesh;
    t.holds(got.how != Insertion::existing, "a surface of its own", "point ", point);
    t.equal(mesh.vertex_count(), old.vertex_count() + 1, "vertices, point ", point);
    t.equal(got.vertex, old.vertex_count(), "number of the new vertex, point ", point);
    t.holds(std::equal(old.positions().begin(), old.positions().end(), mesh.positions().begin()),
            "the old vertices stay", "point ", point);
    t.holds(mesh.positions()[got.vertex] == s.sample.points[point], "the place of the point", "point ", point);
    t.holds(mesh.manifold() && mesh.oriented() && mesh.closed(), "manifold, oriented, closed", "point ", point);
    t.equal(mesh.face_count(), old.face_count() + 2, "faces: the Euler number stays, point ", point);
  }
}

}  // namespace

DemandTable inserter_demands() {
  return {
      demand<ReconstructorTrial, own_vertices>("inserter.own_vertices",
                                               "inserting a vertex gives the reconstruction itself"),
      demand<ReconstructorTrial, other_points>("inserter.other_points",
                                               "inserting another point keeps all vertices and the kind of surface"),
  };
}

}  // namespace geodrome::conformance
