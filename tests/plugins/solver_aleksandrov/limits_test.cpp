// SPDX-License-Identifier: MIT
#include "geodrome/errors.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"
#include "plugins/solver_aleksandrov/graph_search.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

/// What is said when a surface is refused; empty if it is not.
std::string remedy_for(const MeshPtr& mesh, const Settings& settings) {
  const PackedMesh surface(mesh);
  try {
    Discretization(surface, settings, QuietContext());
  } catch (const RefusedError& error) {
    return error.remedy();
  }
  return {};
}

/// 512 faces, on which a search would take 7 GB.
TEST(Discretization, RefusesWhatTakesTooMuchMemory) {
  const MeshPtr mesh = std::make_shared<const SurfaceMesh>(shapes::fuzz_mesh(5119).mesh);
  EXPECT_EQ(remedy_for(mesh, {.delta = 1, .triangulation = Triangulation::flipped}), "");
  const std::string remedy = remedy_for(mesh, {.delta = 0.5});
  EXPECT_EQ(remedy.find("triangulation"), std::string::npos) << "that is in use: " << remedy;
  EXPECT_NE(remedy.find("delta"), std::string::npos) << remedy;
}

TEST(Discretization, NamesAsRemediesOptionsThatAreNotInUse) {
  const MeshPtr seam = geodrome::test::seam(10, 10);
  EXPECT_EQ(remedy_for(seam, {.delta = 0.5}), "");
  const std::string remedy = remedy_for(seam, {.delta = 1, .triangulation = Triangulation::as_is});
  EXPECT_NE(remedy.find("triangulation=refined"), std::string::npos) << remedy;
  EXPECT_EQ(remedy.find("delta"), std::string::npos) << "none larger is allowed: " << remedy;
}

/// Is cancelled from the start.
class Stopped : public QuietContext {
 public:
  bool cancelled() const noexcept override { return ++polls > 1; }
  mutable int polls = 0;
};

/// Nodes that see many others take long: less than a thousand of them are settled.
TEST(GraphSearch, CanBeCancelledWhereNodesSeeMany) {
  const MeshPtr needles = geodrome::test::mapped(geodrome::test::plane_grid(4), [](const Vec3& p) {
    return Vec3{p.x, 1e-3 * p.y, 0};
  });
  const PackedMesh surface(needles);
  const Discretization made(surface, {.delta = 1, .triangulation = Triangulation::as_is}, QuietContext());
  GraphSearch search(made.graph());
  search.begin();
  search.seed(0, 0, 0);
  const Stopped stopped;
  EXPECT_THROW(search.run(stopped, INFINITY, [] { return std::numeric_limits<double>::infinity(); }), Cancelled);
  EXPECT_LT(search.edges_compared(), 3 * GraphSearch::edges_a_poll);
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
