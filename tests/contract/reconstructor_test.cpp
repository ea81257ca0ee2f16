// SPDX-License-Identifier: MIT
// Every reconstructor: an oriented manifold of the right shape, or a refusal.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "geodrome/surface_reconstructor.hpp"
#include "support/discovered.hpp"
#include "support/meshes.hpp"
#include "support/sample_stages.hpp"
#include "support/volume.hpp"

namespace geodrome::test {
namespace {

using ReconstructorPlugin = Discovered<SurfaceReconstructor>;

Reconstruction reconstruct(const ReconstructorPlugin& plugin, const Staged& s) {
  QuietContext context;
  return plugin.object->reconstruct(s.sample, s.tangents, s.control, s.kept, context);
}

/// All points kept.
Reconstruction reconstruct(const ReconstructorPlugin& plugin, const PointSample& sample) {
  return reconstruct(plugin, staged(sample, false));
}

/// For samples that stages 1 to 3 would refuse themselves.
Staged unstaged(const PointSample& sample) {
  Staged s{sample, {}, {}, {}};
  for (Index i = 0; i < sample.size(); ++i) {
    s.tangents.plane.push_back({sample.points[i], {0, 0, 1}, 0});
    s.kept.push_back(i);
  }
  s.tangents.state.assign(sample.size(), PointState::ok);
  s.control = {std::vector<double>(sample.size(), 1), std::vector<double>(sample.size(), 1), s.tangents.state};
  return s;
}

PointSample points_of(const MeshPtr& mesh) { return {{mesh->positions().begin(), mesh->positions().end()}}; }

long euler_number(const SurfaceMesh& mesh) {
  std::size_t edges_twice = 0;
  for (const Index twin : mesh.twins()) edges_twice += twin == no_index ? 2 : 1;
  return static_cast<long>(mesh.vertex_count()) - static_cast<long>(edges_twice / 2) +
         static_cast<long>(mesh.face_count());
}

std::size_t component_count(const SurfaceMesh& mesh) {
  detail::DisjointSets sets(mesh.vertex_count());
  for (const Triangle& t : mesh.triangles()) sets.unite(t[0], t[1]), sets.unite(t[0], t[2]);
  std::size_t count = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) count += sets.find(v) == v;
  return count;
}

bool reports(const Reconstruction& result, const char* code) {
  return std::any_of(result.findings.begin(), result.findings.end(), [&](const Finding& f) { return f.code == code; });
}

class Reconstructors : public testing::TestWithParam<ReconstructorPlugin> {
 protected:
  static void expect_sound(const Reconstruction& result, const PointSample& sample) {
    ASSERT_TRUE(result.mesh);
    EXPECT_TRUE(result.mesh->manifold());
    EXPECT_TRUE(result.mesh->oriented());
    ASSERT_EQ(result.sample_of_vertex.size(), result.mesh->vertex_count());
    for (Index v = 0; v < result.mesh->vertex_count(); ++v) {
      EXPECT_NE(result.mesh->first_half_edge(v), no_index) << "vertex " << v << " is on no face";
      if (result.sample_of_vertex[v] != no_index) {
        EXPECT_EQ(result.mesh->positions()[v], sample.points[result.sample_of_vertex[v]]);
      }
    }
  }
};

TEST_P(Reconstructors, MakeATorusOfATorus) {
  const PointSample sample = points_of(bumpy_torus(60, 24, 0.01, 3));
  const Staged s = staged(sample, false);
  const Reconstruction result = reconstruct(GetParam(), s);
  expect_sound(result, s.sample);
  EXPECT_TRUE(result.mesh->closed());
  EXPECT_EQ(euler_number(*result.mesh), 0);
  EXPECT_EQ(result.mesh->vertex_count(), sample.size());
}

TEST_P(Reconstructors, OrientClosedSurfacesOutwards) {
  const Reconstruction result = reconstruct(GetParam(), points_of(bumpy_torus(48, 20, 0.01, 5)));
  const double torus = 2 * std::numbers::pi * std::numbers::pi * 0.4 * 0.4;
  EXPECT_NEAR(volume(*result.mesh), torus, 0.1 * torus);
}

TEST_P(Reconstructors, KeepTheBoundaryOfATube) {
  const PointSample sample = points_of(prism(40, 12, 0.16));
  const Staged s = staged(sample, false);
  const Reconstruction result = reconstruct(GetParam(), s);
  expect_sound(result, s.sample);
  EXPECT_EQ(euler_number(*result.mesh), 0) << "a tube has two boundary loops and Euler number 0";
  EXPECT_FALSE(result.mesh->closed());
  EXPECT_TRUE(reports(result, "boundary"));
}

TEST_P(Reconstructors, TriangulateAPlanarGridInItsPlane) {
  const PointSample sample = points_of(mapped(plane_grid(12), [](const Vec3& p) {
    return Vec3{p.x, 0.6 * p.y, 5 + 0.8 * p.y};
  }));
  const Staged s = staged(sample, false);
  const Reconstruction result = reconstruct(GetParam(), s);
  expect_sound(result, s.sample);
  EXPECT_EQ(result.mesh->face_count(), 2u * 12 * 12);
  EXPECT_EQ(euler_number(*result.mesh), 1);
}

TEST_P(Reconstructors, DoNotFillTheNotchOfAPlanarSample) {
  PointSample sample;
  for (const Vec3& p : plane_grid(16)->positions())
    if (p.x <= 4 || p.y <= 4) sample.points.push_back(p);
  const Staged s = staged(sample, false);
  const Reconstruction result = reconstruct(GetParam(), s);
  expect_sound(result, s.sample);
  for (Index h = 0; h < 3 * result.mesh->face_count(); ++h) {
    const Vec3 p = result.mesh->positions()[result.mesh->from(h)], q = result.mesh->positions()[result.mesh->to(h)];
    EXPECT_LT(distance(p, q), 12) << "the notch is closed by an edge over its mouth, which is 12 sqrt(2) wide";
  }
}

TEST_P(Reconstructors, DoNotBridgeClusters) {
  std::ifstream file(GEODROME_SHARED_DATA "/bad/two_clusters.xyz");
  if (!file) GTEST_SKIP() << "the file is not there";
  PointSample sample;
  for (Vec3 p; file >> p.x >> p.y >> p.z;) sample.points.push_back(p);
  const Staged s = staged(sample, false);
  const Reconstruction result = reconstruct(GetParam(), s);
  expect_sound(result, s.sample);
  EXPECT_EQ(component_count(*result.mesh), 2u);
}

TEST_P(Reconstructors, RefuseALine) {
  PointSample sample;
  for (int i = 0; i < 30; ++i) sample.points.push_back({0.1 * i, 0.2 * i, 0.3 * i});
  EXPECT_THROW(reconstruct(GetParam(), unstaged(sample)), SampleError);
}

TEST_P(Reconstructors, RefuseTwoPoints) {
  EXPECT_THROW(reconstruct(GetParam(), unstaged({{{0, 0, 0}, {1, 0, 0}}})), SampleError);
}

TEST_P(Reconstructors, GiveTheSameFacesAgain) {
  const PointSample sample = points_of(bumpy_torus(30, 14, 0.02, 7));
  const Reconstruction a = reconstruct(GetParam(), sample), b = reconstruct(GetParam(), sample);
  EXPECT_TRUE(std::equal(a.mesh->triangles().begin(), a.mesh->triangles().end(), b.mesh->triangles().begin(),
                         b.mesh->triangles().end()));
}

INSTANTIATE_TEST_SUITE_P(Every, Reconstructors, testing::ValuesIn(discovered<SurfaceReconstructor>()),
                         [](const auto& info) { return info.param.name; });

TEST(BoundaryRule, ClosedRefusesAHole) {
  const auto options = +[](const std::string&) -> std::string { return "boundary=closed"; };
  for (const ReconstructorPlugin& plugin : discovered<SurfaceReconstructor>(options)) {
    EXPECT_THROW(reconstruct(plugin, points_of(plane_grid(8))), SampleError) << plugin.name;
    EXPECT_TRUE(reconstruct(plugin, points_of(bumpy_torus(40, 16, 0.01, 9))).mesh->closed()) << plugin.name;
  }
}

}  // namespace
}  // namespace geodrome::test
