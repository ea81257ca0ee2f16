// SPDX-License-Identifier: MIT
// Every reconstructor that can insert points: what PointInserter promises.
#include <gtest/gtest.h>

#include <algorithm>

#include "geodrome/surface_reconstructor.hpp"
#include "support/discovered.hpp"
#include "support/meshes.hpp"

namespace geodrome::test {
namespace {

using ReconstructorPlugin = Discovered<SurfaceReconstructor>;

Vec3 torus_point(double u, double v) {
  const double r = 1 + 0.4 * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
}

Vec3 torus_normal(const Vec3& p) {
  const double ring = std::hypot(p.x, p.y);
  const Vec3 out = p - Vec3{p.x / ring, p.y / ring, 0};
  return out / norm(out);
}

/// A torus: points that are kept, and random ones that are not.
struct Sample {
  static constexpr std::size_t extra = 60;
  PointSample points;
  Tangents tangents;
  Control control;
  std::vector<Index> kept;

  Sample() {
    const MeshPtr mesh = bumpy_torus(60, 24, 0.01, 3);
    points.points.assign(mesh->positions().begin(), mesh->positions().end());
    for (Index i = 0; i < points.size(); ++i) kept.push_back(i);
    std::mt19937_64 random(8);
    for (std::size_t i = 0; i < extra; ++i)
      points.points.push_back(
          torus_point(2 * std::numbers::pi * uniform(random), 2 * std::numbers::pi * uniform(random)));
    for (const Vec3& p : points.points) tangents.plane.push_back({p, torus_normal(p), 0});
    tangents.state.assign(points.size(), PointState::ok);
    control.psi.assign(points.size(), 0.15);  // the mesh's edges are 0.06 to 0.2 long
    control.phi = control.psi;
    control.state = tangents.state;
  }
};

class Inserters : public testing::TestWithParam<ReconstructorPlugin> {
 protected:
  void SetUp() override {
    QuietContext context;
    made_ = GetParam().object->reconstruct(sample_.points, sample_.tangents, sample_.control, sample_.kept, context);
    if (!made_.inserter) GTEST_SKIP() << GetParam().name << " cannot insert points";
  }
  Sample sample_;
  Reconstruction made_;
};

TEST_P(Inserters, GiveTheReconstructionForItsOwnVertices) {
  for (Index v = 0; v < made_.mesh->vertex_count(); v += 17) {
    const Inserted got = made_.inserter->with(made_.sample_of_vertex[v]);
    EXPECT_EQ(got.mesh, made_.mesh);
    EXPECT_EQ(got.vertex, v);
    EXPECT_EQ(got.how, Insertion::existing);
  }
}

TEST_P(Inserters, KeepAllVerticesAndTheKindOfTheSurface) {
  for (Index s = static_cast<Index>(sample_.kept.size()); s < sample_.points.size(); ++s) {
    const Inserted got = made_.inserter->with(s);
    ASSERT_NE(got.how, Insertion::existing);
    const SurfaceMesh &mesh = *got.mesh, &old = *made_.mesh;
    ASSERT_EQ(mesh.vertex_count(), old.vertex_count() + 1);
    EXPECT_EQ(got.vertex, old.vertex_count());
    EXPECT_TRUE(std::equal(old.positions().begin(), old.positions().end(), mesh.positions().begin()));
    EXPECT_EQ(mesh.positions()[got.vertex], sample_.points.points[s]);
    EXPECT_TRUE(mesh.manifold());
    EXPECT_TRUE(mesh.oriented());
    EXPECT_TRUE(mesh.closed());
    EXPECT_EQ(mesh.face_count(), old.face_count() + 2) << "with one vertex more: the Euler number stays";
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Inserters, testing::ValuesIn(discovered<SurfaceReconstructor>()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace geodrome::test
