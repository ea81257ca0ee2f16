// SPDX-License-Identifier: MIT
#include "tests/plugins/solvers/fixture.hpp"

namespace geodrome::test {
namespace {

/// The exact solvers that are made here, not by others.
class FlatFace : public EverySolver {};

/// A vertex on a slit: edges from it to `a` and `b` on one line, joined by a face without area to the edge from a to b,
/// beyond which lies `tip`. Below the edge to a, a fan goes on to beyond the edge to b, from which a slit parts it.
struct Slit {
  static constexpr Index corner = 0, a = 1, b = 2, tip = 3, source = 4;
  MeshPtr mesh;

  /// The source sees the edge to a at this angle, along the other edge.
  Slit(double angle, bool mirrored, shapes::Random& random) {
    const double turn = random.uniform(0, 6), tilt = random.uniform(0, 6), far = random.uniform(0.5, 5);
    const Vec3 u{std::cos(turn) * std::cos(tilt), std::sin(turn) * std::cos(tilt), std::sin(tilt)};
    const Vec3 v{-std::sin(turn), std::cos(turn), 0};
    const Vec3 end = random.uniform(0.1, 2) * u;
    std::vector<Vec3> positions{
        {}, -1.0 * end, end, random.uniform(-1, 1) * u + v, far * (std::cos(angle) * u - std::sin(angle) * v)};
    std::vector<Triangle> triangles{{a, corner, b}, {a, b, tip}};
    Index before = a;
    for (double way = 3.3; way < 6; way += random.uniform(0.1, 2)) {
      const auto next = static_cast<Index>(positions.size());
      positions.push_back(random.uniform(0.3, 3) * (std::cos(way) * u + std::sin(way) * v));
      triangles.push_back({corner, before, next});
      before = next;
    }
    triangles.push_back({corner, before, source});
    if (mirrored)
      for (Triangle& t : triangles) std::swap(t[1], t[2]);
    mesh = share(SurfaceMesh(std::move(positions), std::move(triangles)));
  }
};

/// The ray that passes the vertex enters the face without area at a place, and at a slant, that rounding moves far
/// along its long edge. Beyond the vertex there is the other side of the slit, where no ray comes.
TEST_P(FlatFace, IsEnteredByGrazingRaysUpToTheVertexOnItsEdge) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    shapes::Random random(seed);
    const double angle = std::pow(10.0, -random.uniform(1, 16));
    const Slit slit(angle, seed % 2 == 0, random);
    const std::vector<double> d = from_vertex(solver_, slit.mesh, Slit::source);
    const auto positions = slit.mesh->positions();
    const double truth = norm(positions[Slit::source]) + norm(positions[Slit::tip]);
    ASSERT_NEAR(d[Slit::tip], truth, 1e-14 * truth) << "seed " << seed << ", angle " << angle;
  }
}

INSTANTIATE_TEST_SUITE_P(Plugins, FlatFace, testing::Values("chen_han", "schreiber"), solver_name);

}  // namespace
}  // namespace geodrome::test
