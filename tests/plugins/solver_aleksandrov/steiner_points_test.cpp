// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/steiner_points.hpp"

#include <algorithm>

#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

/// A bisector with its placement, and what the formulas need.
struct Placed {
  Bisector points;
  double whole;   ///< from the vertex to the opposite side
  double radius;  ///< of the star around the vertex
  double tangent, sine, cosine;
};

/// Calls `check` for every corner of some meshes that has Steiner points; `more` than a few.
template <class Check>
void for_each_bisector(Placement placement, double delta, Check&& check) {
  int count = 0;
  for (const auto& [name, mesh] : fair_meshes(3)) {
    SCOPED_TRACE(name + ", delta " + std::to_string(delta));
    const PackedMesh surface(mesh);
    const IntrinsicTriangulation t(surface, tiny);
    const SteinerPlacement where(t, placement, delta, 1);
    std::vector<double> star(t.vertex_count(), INFINITY);
    for (Index h = 0; h < 3 * t.face_count(); ++h)
      star[t.from(h)] = std::min(star[t.from(h)], to_opposite_side(t.face(h / 3), static_cast<int>(h % 3)));
    for (Index h = 0; h < 3 * t.face_count(); ++h) {
      const double p = t.length(h), q = t.length(SurfaceMesh::previous(h)), half = angle(t, h) / 2;
      const Placed placed{where.at(h),     2 * p * q * std::cos(half) / (p + q),
                          star[t.from(h)], std::tan(half),
                          std::sin(half),  std::cos(half)};
      if (placed.points.count == 0) continue;
      ++count;
      check(placed);
    }
  }
  EXPECT_GT(count, 200);
}

/// eta for a bisector, with what vicinities leave of delta (kappa = 0.07: a way that enters one is longer by a share of
/// 4 kappa delta at most).
double thin_step(double delta, double tangent) {
  const double share = 0.07 * delta, left = delta - 4 * share / (1 - 4 * share);
  return std::min(0.95, tangent * std::sqrt((1 + left) * (1 + left) - 1));
}

TEST(SteinerPoints, OfTheThinPlacementAreWithinAStepOfEveryPlaceOutsideTheVicinity) {
  for (const double delta : {1.0, 0.5, 0.1, 0.01})
    for_each_bisector(Placement::thin, delta, [&](const Placed& b) {
      const double eta = thin_step(delta, b.tangent), vicinity = 0.07 * delta * b.radius;
      // The farthest places are the vicinity's border, where two steps meet, and the opposite side.
      double at = b.points.first, nearest = vicinity;
      for (double k = 0; k < b.points.count; ++k, at *= b.points.ratio) {
        ASSERT_GE(at, vicinity * (1 - 1e-9)) << "inside the vicinity";
        const double meet = k == 0 ? vicinity : (at + at / b.points.ratio) / 2;
        ASSERT_LE(at - meet, eta * meet * (1 + 1e-9)) << k;
        nearest = at;
      }
      ASSERT_LE(nearest, b.whole * (1 + 1e-9));
      ASSERT_LE(b.whole - nearest, eta * b.whole * (1 + 1e-9));
    });
}

/// Steps as long as they may be would be fewer by less than one.
TEST(SteinerPoints, OfTheThinPlacementAreNoMoreThanTheStepsNeed) {
  for (const double delta : {1.0, 0.1})
    for_each_bisector(Placement::thin, delta, [&](const Placed& b) {
      const double eta = thin_step(delta, b.tangent), cell = std::log((1 + eta) / (1 - eta));
      ASSERT_LE(b.points.count, std::log(b.whole / (0.07 * delta * b.radius)) / cell + 1 + 1e-9);
    });
}

TEST(SteinerPoints, OfThePublishedPlacementAreWhereTheFormulasSay) {
  for (const double delta : {0.4, 0.1, 0.01})
    for_each_bisector(Placement::published, delta, [&](const Placed& b) {
      const double radius = delta * b.radius / 7;
      ASSERT_NEAR(b.points.first, radius * b.cosine, 1e-12 * radius);
      ASSERT_NEAR(b.points.ratio, 1 + b.sine * std::sqrt(delta / 2), 1e-12);
      const double last = b.points.first * std::pow(b.points.ratio, b.points.count - 1);
      ASSERT_LE(last, b.whole * (1 + 1e-9));
      ASSERT_GT(last * b.points.ratio, b.whole * (1 - 1e-9));
    });
}

/// No shortest path crosses such an angle to go on.
TEST(SteinerPoints, AreNotOnAnglesWithALegOnTheBoundary) {
  const PackedMesh surface(geodrome::test::terrain(5, 0.5, 1));
  const IntrinsicTriangulation t(surface, tiny);
  for (const Placement placement : {Placement::thin, Placement::published}) {
    const SteinerPlacement where(t, placement, 0.1, 1);
    int without = 0;
    for (Index h = 0; h < 3 * t.face_count(); ++h) {
      const Index before = SurfaceMesh::previous(h);
      const bool border = t.next_on_edge(h) == h || t.next_on_edge(before) == before;
      without += border;
      ASSERT_EQ(where.at(h).count == 0, border) << h;
    }
    EXPECT_EQ(without, 38);  // twenty boundary edges, an angle at either end; two corners have both legs there
  }
}

double points_in_all(Placement placement, double delta) {
  double points = 0;
  for_each_bisector(placement, delta, [&](const Placed& b) { points += b.points.count; });
  return points;
}

/// As delta^-1/2 log(1/delta), the constant within a factor of two over three powers of ten.
TEST(SteinerPoints, GrowInNumberAsTheTheoremSays) {
  for (const Placement placement : {Placement::thin, Placement::published}) {
    double least = INFINITY, most = 0;
    for (const double delta : {0.1, 0.01, 0.001, 0.0001}) {
      const double constant = points_in_all(placement, delta) * std::sqrt(delta) / std::log(1 / delta);
      least = std::min(least, constant), most = std::max(most, constant);
    }
    EXPECT_LT(most / least, 2);
  }
}

// ---- the lemma behind the thin placement

/// How much longer the way from a to b is through a point on the bisector that is moved away from the crossing by
/// `move` times its distance from the vertex; a and b are on the legs.
double detour(double half, double a, double b, double move) {
  const Point2 p{a * std::cos(half), a * std::sin(half)}, q{b * std::cos(half), -b * std::sin(half)};
  const double crossing = 2 * a * b * std::cos(half) / (a + b);
  const Point2 x{crossing * (1 + move), 0};
  return (length(p - x) + length(x - q)) / length(p - q);
}

double bound(double half, double eta) { return std::sqrt(1 + eta * eta / (std::tan(half) * std::tan(half))); }

TEST(MovedCrossing, LengthensAWayByNoMoreThanTheBound) {
  Random random(1);
  for (int i = 0; i < 1000000; ++i) {
    const double half = random.uniform(0.001, 1.57), eta = random.uniform(0, 0.95);
    const double a = std::pow(10, random.uniform(-4, 4)), move = eta * random.uniform(-1, 1);
    ASSERT_LE(detour(half, a, 1, move), bound(half, eta) * (1 + 1e-13)) << half << " " << eta << " " << a;
  }
}

/// The worst is a = b, where the bound is the truth: near it, and over all thin angles.
TEST(MovedCrossing, HasTheBoundWhereTheLegsAreEquallyLong) {
  Random random(2);
  for (int i = 0; i < 1000000; ++i) {
    const double half = std::pow(10, -random.uniform(0, 8)), eta = random.uniform(0.01, 0.95);
    const double a = 1 + std::pow(10, -random.uniform(0, 12)), move = random.index(2) ? eta : -eta;
    ASSERT_LE(detour(half, a, 1, move), bound(half, eta) * (1 + 1e-13)) << half << " " << eta << " " << a;
    ASSERT_NEAR(detour(half, 1, 1, move), bound(half, eta), 1e-13 * bound(half, eta)) << half << " " << eta;
  }
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
