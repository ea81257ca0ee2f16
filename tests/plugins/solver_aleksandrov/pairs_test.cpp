// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <set>
#include <sstream>

#include "plugins/solver_aleksandrov/pairs/least_sum.hpp"
#include "plugins/solver_aleksandrov/pairs/pair_index.hpp"
#include "plugins/solver_aleksandrov/pairs/pair_oracle.hpp"
#include "plugins/solver_aleksandrov/pairs/region_tree.hpp"
#include "plugins/solver_aleksandrov/strip_scan.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"
#include "tests/support/meshes.hpp"

namespace geodrome::aleksandrov {
namespace {

using test::uniform;

TEST(LeastSum, IsThatOfAllSizes) {
  std::mt19937_64 random(1);
  for (std::size_t count = 0; count < 70; ++count) {
    std::vector<float> a(count), b(count);
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = static_cast<float>(uniform(random)), b[i] = static_cast<float>(uniform(random));
      least = std::min(least, a[i] + b[i]);
    }
    EXPECT_EQ(least_sum(a.data(), b.data(), count), least) << count;
  }
}

TEST(StripScan, FindsWhatALoopFinds) {
  std::mt19937_64 random(2);
  for (std::size_t count = 0; count < 60; ++count) {
    std::vector<double> t(count), best(count);
    for (std::size_t i = 0; i < count; ++i) {
      t[i] = uniform(random), best[i] = 2 + uniform(random);
      if (random() % 5 == 0) best[i] = std::numeric_limits<double>::infinity();
      if (random() % 5 == 0) best[i] = 1;
    }
    const double x = uniform(random), y = uniform(random), dx = uniform(random), dy = -uniform(random);
    std::vector<Index> wanted, found;
    for (std::size_t i = 0; i < count; ++i) {
      const double px = x - t[i] * dx, py = y - t[i] * dy, slack = best[i] - 1.5;
      if (slack >= 0 && px * px + py * py <= slack * slack) wanted.push_back(static_cast<Index>(7 + i));
    }
    scan_strip(t.data(), best.data(), count, 1.5, x, y, dx, dy, 7, found);
    EXPECT_EQ(found, wanted) << count;
  }
}

/// Every face is in the two halves once, and whatever both halves have in common is a portal.
TEST(RegionTree, CutsInHalvesWithPortalsBetween) {
  const MeshPtr mesh = test::bumpy_torus(24, 12, 0.1, 3);
  const RegionTree tree(*mesh, 0.02, 50, QuietContext());
  const auto& regions = tree.regions();
  ASSERT_GT(regions.size(), 8u);
  EXPECT_EQ(regions[0].faces.size(), mesh->face_count());
  for (Index r = 0; r < regions.size(); ++r) {
    std::vector<const Region*> halves;
    for (const Region& other : regions)
      if (other.parent == r) halves.push_back(&other);
    if (halves.empty()) {
      EXPECT_LE(regions[r].faces.size(), 50u);
      continue;
    }
    ASSERT_EQ(halves.size(), 2u);
    std::set<Index> faces[2], vertices[2], portals;
    for (int k = 0; k < 2; ++k)
      for (const Index f : halves[k]->faces) {
        EXPECT_TRUE(faces[k].insert(f).second);
        vertices[k].insert(mesh->triangles()[f].begin(), mesh->triangles()[f].end());
      }
    EXPECT_EQ(faces[0].size() + faces[1].size(), regions[r].faces.size());
    EXPECT_LE(std::max(faces[0].size(), faces[1].size()), 2 * std::min(faces[0].size(), faces[1].size()));
    for (const SurfacePoint& portal : regions[r].portals)
      if (mesh->vertex_at(portal) != no_index) portals.insert(mesh->vertex_at(portal));
    std::set<Index> common;
    std::set_intersection(vertices[0].begin(), vertices[0].end(), vertices[1].begin(), vertices[1].end(),
                          std::inserter(common, common.end()));
    EXPECT_EQ(portals, common);
    EXPECT_LE(regions[r].detour, 0.02);
    EXPECT_GT(regions[r].portals.size(), portals.size());
  }
}

class PairBounds : public testing::Test {
 protected:
  const test::ExactSolver exact_;
  const MeshPtr mesh_ = test::both(test::terrain(13, 2, 5), test::mapped(test::bumpy_torus(16, 8, 0.1, 7), [](Vec3 p) {
                                     return p + Vec3{0, 0, 90};
                                   }));
  QuietContext context_;
  const PairIndex index_{mesh_, 0.3, exact_, context_};
};

TEST_F(PairBounds, HoldTheDistanceBetweenThem) {
  std::size_t settled = 0, pairs = 0;
  for (Index from = 0; from < mesh_->vertex_count(); from += 11) {
    const auto truth = distances(exact_, mesh_, mesh_->at_vertex(from));
    for (Index to = 0; to < mesh_->vertex_count(); ++to) {
      const Bounds bounds = index_.between(from, to);
      if (std::isinf(truth[to])) {
        EXPECT_TRUE(std::isinf(bounds.most));
        continue;
      }
      EXPECT_LE(bounds.least, truth[to] * (1 + 1e-12));
      EXPECT_GE(bounds.most, truth[to] * (1 - 1e-12));
      settled += bounds.most <= 1.2 * bounds.least, ++pairs;
    }
  }
  EXPECT_GT(settled, pairs / 2);
}

TEST_F(PairBounds, AreTheSameAfterSavingAndReading) {
  std::stringstream file;
  index_.save(file);
  const PairIndex again(*mesh_, file);
  for (Index v = 0; v < mesh_->vertex_count(); v += 3) {
    EXPECT_EQ(index_.between(5, v).least, again.between(5, v).least);
    EXPECT_EQ(index_.between(5, v).most, again.between(5, v).most);
  }
}

/// Whatever byte is wrong, it is refused or harmless.
TEST_F(PairBounds, AreRefusedWhereTheFileIsCutOffOrDamaged) {
  std::stringstream file;
  index_.save(file);
  const std::string whole = file.str();
  for (std::size_t size = 0; size < whole.size(); size = 2 * size + 1) {
    std::istringstream cut(whole.substr(0, size));
    EXPECT_THROW(PairIndex(*mesh_, cut), InputError) << size;
  }
  std::mt19937_64 random(9);
  for (int i = 0; i < 300; ++i) {
    std::string bad = whole;
    bad[random() % std::min<std::size_t>(bad.size(), 4096)] ^= static_cast<char>(1 + random() % 255);
    std::istringstream in(bad);
    try {
      const PairIndex index(*mesh_, in);
      for (Index v = 0; v < mesh_->vertex_count(); ++v) index.between(v, 3);
    } catch (const InputError&) {
    }
  }
}

TEST_F(PairBounds, AreRefusedWithADetourThatIsNoLength) {
  std::stringstream file;
  index_.save(file);
  // After the format and the number of regions: parent, depth, columns, detour.
  constexpr std::size_t at = 8 + 8 + 16;
  for (const double detour : {-1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    std::string bad = file.str();
    std::memcpy(bad.data() + at, &detour, sizeof detour);
    std::istringstream in(bad);
    EXPECT_THROW(PairIndex(*mesh_, in), InputError) << detour;
  }
}

TEST_F(PairBounds, AreRefusedWithADistanceThatIsNone) {
  std::stringstream file;
  index_.save(file);
  for (const float distance : {-1.0f, std::numeric_limits<float>::quiet_NaN()}) {
    std::string bad = file.str();
    std::memcpy(bad.data() + bad.size() - sizeof distance, &distance, sizeof distance);
    std::istringstream in(bad);
    EXPECT_THROW(PairIndex(*mesh_, in), InputError) << distance;
  }
}

/// An oracle and the surface it answers for.
struct Oracle {
  Oracle(const MeshPtr& mesh, double delta)
      : surface(mesh),
        pairs(make_pair_oracle(std::make_shared<const Discretization>(surface, Settings{.delta = delta}, context),
                               delta, test::ExactSolver(), nullptr, context)) {}
  double distance(const SurfacePoint& p, const SurfacePoint& q) const { return pairs->distance(p, q); }

  QuietContext context;
  const PackedMesh surface;
  const std::unique_ptr<PairOracle> pairs;
};

/// Far nearer to the tip of a cone than its faces are wide.
TEST(PairOracle, KeepsTheFactorNextToAVertex) {
  constexpr double wide = 1, delta = 0.1, rounding_of_places = 1e-14;
  const Oracle oracle(test::fan(5, wide), delta);
  std::mt19937_64 random(11);
  for (int n = 0; n < 300; ++n) {
    const double r = std::pow(10, -9 * test::uniform(random)) / 2, s = r * (0.5 + test::uniform(random) / 2);
    const double edge = std::pow(10, -8 * test::uniform(random));
    const double a = wide * (1 - edge), b = wide * edge * test::uniform(random);
    const auto at = [&](Index face, double away, double angle) {
      const double b1 = away * std::sin(wide - angle) / std::sin(wide), b2 = away * std::sin(angle) / std::sin(wide);
      return SurfacePoint{face, {1 - b1 - b2, b1, b2}};
    };
    const Index face = static_cast<Index>(random() % 5), apart = 1 + static_cast<Index>(random() % 2);
    const double one_way = apart * wide + b - a, turn = std::min(one_way, 5 * wide - one_way);
    const double truth = std::hypot(r - s, 2 * std::sqrt(r * s) * std::sin(turn / 2));
    const double found = oracle.distance(at(face, r, a), at((face + apart) % 5, s, b));
    EXPECT_LE(found, (1 + delta) * truth + rounding_of_places)
        << r << " " << s << " " << a << " " << b << ", apart " << apart;
    EXPECT_GE(found, truth - rounding_of_places);
  }
}

/// Coordinates whose squares are no numbers any more, and such as floats cannot hold.
TEST(PairOracle, AnswersAlikeInAnyUnit) {
  const MeshPtr mesh = test::bumpy_torus(30, 16, 0.1, 7);
  const auto oracle_at = [&](int exponent) {
    const MeshPtr other = test::mapped(mesh, [&](const Vec3& p) {
      return Vec3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    });
    return std::make_unique<Oracle>(other, 0.1);
  };
  const auto plain = oracle_at(0);
  for (const int exponent : {-530, -330, -146, -130, 120, 140, 330, 530}) {
    SCOPED_TRACE(testing::Message() << "times 2^" << exponent);
    const auto oracle = oracle_at(exponent);
    std::mt19937_64 random(8);
    for (int n = 0; n < 50; ++n) {
      const SurfacePoint p = test::random_point(*mesh, random), q = test::random_point(*mesh, random);
      EXPECT_EQ(std::ldexp(oracle->distance(p, q), -exponent), plain->distance(p, q));
    }
  }
}

}  // namespace
}  // namespace geodrome::aleksandrov
