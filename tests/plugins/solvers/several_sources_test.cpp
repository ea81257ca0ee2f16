// SPDX-License-Identifier: MIT
// The nearest of several sources that crowd: inside one face, on its edges, at its corners, in its neighbours, at one
// place twice, with start distances. Exact solvers against the least of single searches by another one.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::test {
namespace {

struct Prepared {
  QuietContext context;
  Plugin<ShortestPathSolver> solver;
  std::unique_ptr<PreparedSurface> surface;
  std::unique_ptr<Search> search;

  Prepared(const std::string& name, const MeshPtr& mesh)
      : solver(load_solver(name)), surface(solver.object->prepare(mesh, context)), search(surface->make_search()) {}
};

SurfacePoint place(Index face, shapes::Random& random) {
  const double a = random.uniform(), b = random.uniform() * (1 - a);
  switch (random.index(4)) {
    case 0:
      return {face, {a, 1 - a, 0}};
    case 1:
      return {face, {0, 0, 1}};
    default:
      return {face, {a, b, 1 - a - b}};
  }
}

/// Most in one face, some in the faces beside it.
std::vector<Source> crowd(const SurfaceMesh& mesh, shapes::Random& random) {
  const auto face = static_cast<Index>(random.index(mesh.face_count()));
  std::vector<Source> sources;
  for (std::size_t i = 0; i < 2 + random.index(4); ++i) {
    const Index twin = mesh.twins()[3 * face + static_cast<Index>(random.index(3))];
    const bool beside = random.index(3) == 0 && twin != no_index;
    sources.push_back({place(beside ? twin / 3 : face, random), random.index(2) == 0 ? 0 : random.uniform()});
    if (random.index(5) == 0) sources.push_back(sources.front());
  }
  return sources;
}

void expect_least_of_single_searches(Prepared& judged, Prepared& single, const SurfaceMesh& mesh,
                                     const std::vector<Source>& sources) {
  std::vector<double> least(mesh.vertex_count(), infinity);
  for (Index i = 0; i < sources.size(); ++i) {
    const Source alone{sources[i].at};
    const auto values = single.search->run({&alone, 1}, {}, single.context).vertices();
    for (std::size_t v = 0; v < values.size(); ++v) least[v] = std::min(least[v], values[v] + sources[i].start);
  }
  const ShortestPathMap& map = judged.search->run(sources, {}, judged.context);
  for (Index v = 0; v < least.size(); ++v)
    ASSERT_NEAR(map.vertices()[v], least[v], 1e-12 * (1 + least[v]))
        << judged.solver.info.name << ", vertex " << v << " from " << sources.size() << " sources around face "
        << sources[0].at.face;
}

TEST(SeveralSources, GiveTheLeastOfSingleSearches) {
  shapes::Random random(97);
  for (const char* name : {"cgal", "chen_han", "schreiber"})
    for (const MeshPtr& mesh :
         {shapes::small::plane_grid(1), shapes::small::terrain(3, 1.0, 5), shapes::small::terrain(6, 2.0, 6)}) {
      Prepared judged(name, mesh), single(std::string(name) == "chen_han" ? "schreiber" : "chen_han", mesh);
      for (int trial = 0; trial < 150; ++trial)
        expect_least_of_single_searches(judged, single, *mesh, crowd(*mesh, random));
    }
}

}  // namespace
}  // namespace geodrome::test
