// SPDX-License-Identifier: MIT
// Exact solvers that share no propagation judge each other: at vertices, in faces, and on edges at simple fractions,
// where on meshes of a pattern rays and vertices meet exactly.
#include <string>
#include <tuple>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/refine.hpp"

namespace geodrome::test {
namespace {

class Agreement {
 public:
  explicit Agreement(MeshPtr mesh) : mesh_(std::move(mesh)) {
    for (const std::string name : {"chen_han", "schreiber"}) {
      const Plugin<ShortestPathSolver> solver = load_solver(name);
      prepared_.push_back(solver.call([&](const ShortestPathSolver& s) { return s.prepare(mesh_, context_); }));
      searches_.push_back(prepared_.back()->make_search());
    }
  }

  /// Of one source, at all vertices, and at places in faces and on edges, kept as a map or as targets.
  void expect_from(const SurfacePoint& at, shapes::Random& random, Keep keep, const std::string& name) {
    const Source source{at};
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 300; ++i) points.push_back(i % 2 ? place(random) : even_place(random));
    std::vector<double> values[2];
    for (int s = 0; s < 2; ++s) {
      const std::span<const SurfacePoint> targets = keep == Keep::map ? std::span<const SurfacePoint>{} : points;
      const ShortestPathMap& map = searches_[s]->run({&source, 1}, {.targets = targets, .keep = keep}, context_);
      values[s].assign(map.vertices().begin(), map.vertices().end());
      for (const SurfacePoint& point : points) values[s].push_back(map.at(point).value);
    }
    EXPECT_LE(worst_difference(values[0], values[1]), 1e-12)
        << name << ", source on face " << at.face << " at " << at.b[0] << " " << at.b[1];
  }

  SurfacePoint place(shapes::Random& random) const {
    const double a = random.uniform(), b = random.uniform();
    return {face(random), a + b > 1 ? std::array{1 - a, 1 - b, a + b - 1} : std::array{a, b, 1 - a - b}};
  }
  /// In a face, on an edge or at a vertex.
  SurfacePoint even_place(shapes::Random& random) const {
    constexpr std::size_t parts = 12;
    const std::size_t a = random.index(parts + 1), b = random.index(2) ? parts - a : random.index(parts - a + 1);
    return {face(random), {a / double{parts}, b / double{parts}, (parts - a - b) / double{parts}}};
  }

 private:
  Index face(shapes::Random& random) const { return static_cast<Index>(random.index(mesh_->face_count())); }

  MeshPtr mesh_;
  QuietContext context_;
  std::vector<std::shared_ptr<const PreparedSurface>> prepared_;
  std::vector<std::unique_ptr<Search>> searches_;
};

void expect_agreement(const MeshPtr& mesh, int sources, std::uint64_t seed, const std::string& name) {
  Agreement agreement(mesh);
  shapes::Random random(seed);
  for (int i = 0; i < sources; ++i)
    agreement.expect_from(i % 2 ? agreement.place(random) : agreement.even_place(random), random,
                          i % 3 ? Keep::map : Keep::targets, name + " source " + std::to_string(i));
}

TEST(ExactSolvers, AgreeOnRandomMeshes) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const MeshPtr& mesh : random_meshes(seed)) expect_agreement(mesh, 6, seed, "random");
}

/// Among them patterns whose vertices lie in line, needles, grids of which nothing is left but lines.
TEST(ExactSolvers, AgreeOnFuzzedMeshes) {
  for (const std::uint64_t seed : {13, 24, 61, 105, 115, 146, 187, 193, 269, 410, 635, 792, 842, 844, 857})
    for (const double scale : {1.0, 1e-6})
      expect_agreement(moved(share(shapes::fuzz_mesh(seed).mesh), [scale](const Vec3& p) { return scale * p; }), 12,
                       seed, "fuzz:" + std::to_string(seed));
}

/// Where vertices lie on edges and many half-edges meet in one place.
TEST(ExactSolvers, AgreeOnRefinedFacesWithoutArea) {
  for (const std::size_t size : {0, 1}) {
    const SurfaceMesh coarse = shapes::hostile("collapsed-faces", size);
    const std::size_t faces = 3 * coarse.face_count();
    for (const MeshPtr& finer :
         {share(shapes::refine_by_midpoints(coarse, faces)), share(shapes::refine_by_points(coarse, faces, 1))})
      expect_agreement(finer, 40, 1 + size, "collapsed faces");
  }
}

TEST(ExactSolvers, AgreeOnHostileMeshes) {
  for (const shapes::HostileFamily& family : shapes::hostile_families())
    expect_agreement(share(shapes::hostile(family.name, 0)), 4, 1, family.name);
}

}  // namespace
}  // namespace geodrome::test
