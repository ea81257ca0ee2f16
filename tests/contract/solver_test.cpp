// SPDX-License-Identifier: MIT
// Every solver: the values of its distances, against formulas and against the reference.
#include <algorithm>
#include <numbers>

#include "contract/solver_contract.hpp"

namespace geodrome::test {
namespace {

class SolverDistances : public SolverContract {
 protected:
  /// From every `step`-th vertex to all others, against `truth(from, to)`.
  template <class Truth>
  void expect_all(const MeshPtr& mesh, Index step, double scale, Truth&& truth) {
    Running running(plugin(), mesh);
    for (Index from = 0; from < mesh->vertex_count(); from += step) {
      const auto values = running.run({{mesh->at_vertex(from)}}).vertices();
      for (Index to = 0; to < mesh->vertex_count(); ++to)
        expect_distance(values[to], truth(from, to), scale, "vertex pair");
    }
  }

  /// Vertices of `mesh` against the reference.
  void expect_as_reference(const MeshPtr& mesh) {
    if (!reference() || reference()->name == plugin().name) GTEST_SKIP() << "nothing to compare with";
    Running running(plugin(), mesh), truth(*reference(), mesh);
    for (Index from = 0; from < mesh->vertex_count(); from += static_cast<Index>(mesh->vertex_count() / 3)) {
      const auto values = copy(running.run({{mesh->at_vertex(from)}}).vertices());
      const auto wanted = truth.run({{mesh->at_vertex(from)}}).vertices();
      const double scale = *std::max_element(wanted.begin(), wanted.end());
      for (Index to = 0; to < mesh->vertex_count(); ++to) expect_distance(values[to], wanted[to], scale, "vertex");
    }
  }
};

TEST_P(SolverDistances, ArePlaneDistancesOnAGrid) {
  const MeshPtr mesh = plane_grid(9);
  GEODROME_FITS(mesh);
  expect_all(mesh, 13, 13, [&](Index a, Index b) { return distance(mesh->positions()[a], mesh->positions()[b]); });
}

TEST_P(SolverDistances, ArePlaneDistancesOnATiltedCrossedGrid) {
  const MeshPtr mesh = mapped(plane_grid(9, true), [](const Vec3& p) {
    return Vec3{p.x, 0.6 * p.y, 0.8 * p.y + 0.3 * p.x};
  });
  GEODROME_FITS(mesh);
  expect_all(mesh, 17, 16, [&](Index a, Index b) { return distance(mesh->positions()[a], mesh->positions()[b]); });
}

TEST_P(SolverDistances, ArePlaneDistancesBetweenAnyPoints) {
  GEODROME_NEEDS(any_point | face_sources);
  const MeshPtr mesh = plane_grid(5, true);
  GEODROME_FITS(mesh);
  std::mt19937_64 random(3);
  Running running(plugin(), mesh);
  for (int k = 0; k < 40; ++k) {
    const SurfacePoint from = random_point(*mesh, random);
    const ShortestPathMap& map = running.map({{from}});
    for (int j = 0; j < 40; ++j) {
      const SurfacePoint to = random_point(*mesh, random);
      const double truth = distance(mesh->position(from), mesh->position(to)), value = map.at(to).value;
      EXPECT_GE(value, truth - rounding * 7);
      if (has(factor_any_point)) {
        EXPECT_LE(value, plugin().factor * truth + rounding * 7);
      }
    }
  }
}

TEST_P(SolverDistances, UnfoldTheCube) {
  const MeshPtr mesh = cube();
  GEODROME_FITS(mesh);
  const double by_differing_axes[] = {0, 1, std::sqrt(2), std::sqrt(5)};
  expect_all(mesh, 1, 3, [&](Index a, Index b) {
    const Index axes = a ^ b;
    return by_differing_axes[(axes & 1) + (axes >> 1 & 1) + (axes >> 2)];
  });
}

TEST_P(SolverDistances, UnrollAPrism) {
  constexpr Index m = 17, n = 6;
  const MeshPtr mesh = prism(m, n, 0.3);
  GEODROME_FITS(mesh);
  const double side = 2 * std::sin(std::numbers::pi / m);
  expect_all(mesh, 23, 4, [&](Index a, Index b) {
    const int around = std::abs(static_cast<int>(a / (n + 1)) - static_cast<int>(b / (n + 1)));
    const int along = std::abs(static_cast<int>(a % (n + 1)) - static_cast<int>(b % (n + 1)));
    return std::hypot(std::min<int>(around, m - around) * side, along * 0.3);
  });
}

/// On a fan of unit triangles the unfolded angle between two rim points decides: past pi the way leads through the
/// apex.
TEST_P(SolverDistances, PassTheApexOfACone) {
  for (const auto& [m, angle] : {std::pair<Index, double>{5, 0.9}, {9, 0.4}, {12, 0.45}}) {
    const MeshPtr mesh = fan(m, angle);
    GEODROME_FITS(mesh);
    expect_all(mesh, 1, 2, [&, m = m, angle = angle](Index a, Index b) {
      if (a == 0 || b == 0) return a == b ? 0.0 : 1.0;
      const int around = std::abs(static_cast<int>(a) - static_cast<int>(b));
      const double turn = std::min<int>(around, static_cast<int>(m) - around) * angle;
      return turn < std::numbers::pi ? 2 * std::sin(turn / 2) : 2;
    });
  }
}

TEST_P(SolverDistances, BendAtASaddle) {
  for (const auto& [m, angle] : {std::pair<Index, double>{8, 1.0471975511965976}, {10, 0.8}, {14, 0.45}}) {
    const MeshPtr mesh = fan(m, angle);
    GEODROME_FITS(mesh);
    expect_all(mesh, 1, 2, [&, m = m, angle = angle](Index a, Index b) {
      if (a == 0 || b == 0) return a == b ? 0.0 : 1.0;
      const int around = std::abs(static_cast<int>(a) - static_cast<int>(b));
      const double turn = std::min<int>(around, static_cast<int>(m) - around) * angle;
      return turn < std::numbers::pi ? 2 * std::sin(turn / 2) : 2;
    });
  }
}

TEST_P(SolverDistances, BendAtAReflexBoundaryCorner) {
  const MeshPtr grid = plane_grid(8);
  std::vector<Triangle> kept;
  for (const Triangle& t : grid->triangles()) {
    const Vec3 centre = (grid->positions()[t[0]] + grid->positions()[t[1]] + grid->positions()[t[2]]) / 3;
    if (centre.x < 4 || centre.y < 4) kept.push_back(t);
  }
  const MeshPtr mesh = make({grid->positions().begin(), grid->positions().end()}, kept);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const Vec3 corner{4, 4, 0};
  const auto values = running.run({{mesh->at_vertex(8)}}).vertices();  // at (0, 8)
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->first_half_edge(v) == no_index) continue;
    const Vec3 p = mesh->positions()[v];
    const bool seen = p.x <= 4 || p.x + p.y <= 8;
    const double truth = seen ? distance({0, 8, 0}, p) : distance({0, 8, 0}, corner) + distance(corner, p);
    expect_distance(values[v], truth, 12);
  }
}

TEST_P(SolverDistances, HoldOnNeedles) {
  const MeshPtr mesh = mapped(plane_grid(8, true), [](const Vec3& p) { return Vec3{p.x, 1000 * p.y, 0}; });
  GEODROME_FITS(mesh);
  expect_all(mesh, 20, 8000, [&](Index a, Index b) { return distance(mesh->positions()[a], mesh->positions()[b]); });
}

TEST_P(SolverDistances, AgreeWithTheReferenceOnABumpyTorus) {
  const MeshPtr mesh = bumpy_torus(24, 12, 0.08, 5);
  GEODROME_FITS(mesh);
  expect_as_reference(mesh);
}

TEST_P(SolverDistances, AgreeWithTheReferenceOnTerrain) {
  const MeshPtr mesh = terrain(16, 2, 7);
  GEODROME_FITS(mesh);
  expect_as_reference(mesh);
}

TEST_P(SolverDistances, AgreeWithTheReferenceOnWildTerrain) {
  const MeshPtr mesh = terrain(12, 20, 11);
  GEODROME_FITS(mesh);
  expect_as_reference(mesh);
}

TEST_P(SolverDistances, AreNeverShorterThanTheStraightLine) {
  const MeshPtr mesh = bumpy_torus(20, 10, 0.1, 13);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  const auto values = running.run({{mesh->at_vertex(7)}}).vertices();
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    EXPECT_GE(values[v], distance(mesh->positions()[7], mesh->positions()[v]) * (1 - rounding));
}

TEST_P(SolverDistances, AreSymmetric) {
  const MeshPtr mesh = terrain(10, 2, 17);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  std::vector<std::vector<double>> rows;
  for (Index v = 0; v < mesh->vertex_count(); v += 15)
    rows.push_back(copy(running.run({{mesh->at_vertex(v)}}).vertices()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double a = rows[i][15 * j], b = rows[j][15 * i];
      EXPECT_LE(std::max(a, b),
                (std::isfinite(plugin().factor) ? plugin().factor : 1) * std::min(a, b) + rounding * 30);
    }
}

TEST_P(SolverDistances, ObeyTheTriangleInequalityBetweenVertices) {
  const MeshPtr mesh = bumpy_torus(14, 8, 0.1, 19);
  GEODROME_FITS(mesh);
  Running running(plugin(), mesh);
  std::vector<std::vector<double>> rows;
  for (Index v = 0; v < mesh->vertex_count(); v += 9)
    rows.push_back(copy(running.run({{mesh->at_vertex(v)}}).vertices()));
  const double factor = std::isfinite(plugin().factor) ? plugin().factor : 1;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows.size(); ++j)
      for (Index v = 0; v < mesh->vertex_count(); ++v)
        EXPECT_LE(rows[i][v], factor * (rows[i][9 * j] + rows[j][v]) + rounding * 10);
}

TEST_P(SolverDistances, ScaleWithTheMesh) {
  const MeshPtr mesh = terrain(10, 2, 23);
  GEODROME_FITS(mesh);
  const auto plain = copy(Running(plugin(), mesh).run({{mesh->at_vertex(60)}}).vertices());
  for (const double scale : {1e-6, 1e6}) {
    const MeshPtr scaled = mapped(mesh, [=](const Vec3& p) { return scale * p; });
    Running running(plugin(), scaled);
    const auto values = running.run({{scaled->at_vertex(60)}}).vertices();
    for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(values[v] / scale, plain[v], rounding * 30) << scale;
  }
}

/// The rotation is by (3, 4, 5) / 5 and rounds coordinates by 1e-16 of the extent.
TEST_P(SolverDistances, DoNotChangeUnderRotation) {
  const MeshPtr mesh = terrain(10, 2, 29);
  GEODROME_FITS(mesh);
  const MeshPtr turned = mapped(mesh, [](const Vec3& p) {
    return Vec3{0.6 * p.x - 0.8 * p.z, p.y, 0.8 * p.x + 0.6 * p.z};
  });
  const auto plain = copy(Running(plugin(), mesh).run({{mesh->at_vertex(5)}}).vertices());
  const auto values = copy(Running(plugin(), turned).run({{mesh->at_vertex(5)}}).vertices());
  if (!exact() && std::isfinite(plugin().factor)) GTEST_SKIP() << "an approximation may differ within its factor";
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_NEAR(values[v], plain[v], rounding * 30);
}

INSTANTIATE_TEST_SUITE_P(Every, SolverDistances, testing::ValuesIn(discovered<ShortestPathSolver>()), plugin_name);

}  // namespace
}  // namespace geodrome::test
