// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "plugins/solver_schreiber/lifetime.hpp"
#include "tests/plugins/solver_schreiber/wavefronts.hpp"

namespace geodrome::schreiber::test {
namespace {

Window window_of(const Generator& g, double length) { return {g.x, g.y, g.sigma, g.low(length), g.high(length), 0, 0}; }

/// One between its neighbours, if it has them. Of these only the rays on its side count: what is beyond the others is
/// nearer to somebody else.
struct Triple {
  std::vector<Window> rivals;
  Window own;

  void add(const Generator& g, double low, double high) { rivals.push_back({g.x, g.y, g.sigma, low, high, 0, 0}); }
  bool is_between_one() const { return rivals.size() == 2 && rivals[0].x == rivals[1].x && rivals[0].y == rivals[1].y; }

  /// How much nearer than its rivals it is at least on its ray over a place, from the half-edge up to a distance, where
  /// they have a line to it; infinite where none has or the ray is not yet above the half-edge.
  double lead_over(double place, double distance) const {
    constexpr int steps = 8;
    const double ux = place - own.x, uy = -own.y, size = std::hypot(ux, uy), share = (distance - own.sigma) / size;
    if (share <= 1) return infinity;
    double lead = infinity;
    for (int i = 0; i <= steps; ++i) {
      const double t = i == steps ? share : std::pow(share, i / static_cast<double>(steps));
      for (const Window& rival : rivals)
        lead = std::min(lead, straight(rival, own.x + t * ux, own.y + t * uy) - own.sigma - t * size);
    }
    return lead;
  }
  /// The largest of all its rays: a net of them, made finer about the best.
  double lead(double distance) const {
    double low = own.low, high = own.high, best = -infinity;
    for (int round = 0; round < 8 && best < 0; ++round) {
      constexpr int rays = 300;
      const double step = (high - low) / rays;
      double at = low;
      for (int i = 0; i <= rays; ++i) {
        const double place = i == rays ? high : low + i * step, lead = lead_over(place, distance);
        if (lead > best) best = lead, at = place;
      }
      low = std::max(own.low, at - 2 * step), high = std::min(own.high, at + 2 * step);
    }
    return best;
  }
};

/// Calls `visit(triple, key, whole)` with every generator of lower envelopes, and with the outermost ones alone.
template <class Visit>
void for_each_triple(std::uint64_t fronts, Visit&& visit) {
  FrontPool pool;
  FrontEditor editor(pool);
  for (std::uint64_t seed = 1; seed <= fronts; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const bool whole = seed % 2 == 0;
    const double length = power(random, 0.1, 2);
    const Front front = envelope(editor, pool, random_windows(random, 6, length, random.uniform(), whole), length);
    for (std::size_t i = 0; i < front.size(); ++i) {
      const Generator g = front[i];
      Triple triple{{}, window_of(g, length)};
      Generator left, right;
      if (i > 0) left = front[i - 1], triple.add(left, -infinity, left.high(length));
      if (i + 1 < front.size()) right = front[i + 1], triple.add(right, right.low(length), infinity);
      const double key = lifetime(i > 0 ? &left : nullptr, g, i + 1 < front.size() ? &right : nullptr);
      if (triple.own.high - triple.own.low > 1e-6 * length) visit(triple, key, whole);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(SchreiberLifetime, UpToTheKeyThereIsAPlaceWhereNoNeighbourIsNearer) {
  int finite = 0, endless = 0, one_sided = 0;
  const auto expect_place = [&](const Triple& triple, double key) {
    const double end = std::isfinite(key) ? key : triple.own.sigma + 1000;
    for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999}) {
      const double distance = triple.own.sigma + share * (end - triple.own.sigma);
      ASSERT_GE(triple.lead(distance), -1e-9 * (1 + distance)) << share << " of " << end;
    }
    std::isfinite(key) ? ++finite : ++endless;
    one_sided += triple.rivals.size() == 1;
  };
  for_each_triple(500, [&](const Triple& triple, double key, bool) { expect_place(triple, key); });
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {  // and where their claims overlap
    SCOPED_TRACE("scene " + std::to_string(seed));
    Random random(seed);
    std::vector<Generator> all;
    const Scene scene = random_scene(random, 1 + seed % 4);
    for (const Entered& e : scene.windows)
      if (e.window.high - e.window.low > 1e-3 * scene.length && e.window.y < -1e-3)
        all.push_back(generator_of(e.window));
    for (std::size_t i = 0; i + 2 < all.size(); ++i) {
      Triple triple{{}, window_of(all[i + 1], scene.length)};
      triple.add(all[i], -infinity, all[i].high(scene.length));
      triple.add(all[i + 2], all[i + 2].low(scene.length), infinity);
      expect_place(triple, lifetime(&all[i], all[i + 1], &all[i + 2]));
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(finite, 1000);
  EXPECT_GT(endless, 300);
  EXPECT_GT(one_sided, 500);
}

/// Where two are equally far at every boundary, the key is no guess: behind it there is no such place. (One that lies
/// before its only neighbour, which is nearer on both sides, may live longer.)
TEST(SchreiberLifetime, BehindTheKeyOfOneOfACellComplexThereIsNone) {
  int finite = 0;
  for_each_triple(1000, [&](const Triple& triple, double key, bool whole) {
    if (!whole || triple.rivals.size() < 2 || triple.is_between_one() || !std::isfinite(key)) return;
    ++finite;
    ASSERT_LT(triple.lead(triple.own.sigma + 1.01 * (key - triple.own.sigma)), 0) << key;
  });
  EXPECT_GT(finite, 150);
}

/// Neighbours at (-d, -h) and (d, -h) that are `ahead`, one at (0, -1) between them: all meet on the axis at r from it,
/// where r + ahead is the distance from (d, -h).
TEST(SchreiberLifetime, OfAMirroredTripleIsWhereTheThreeMeet) {
  Random random(1);
  int met = 0;
  for (int i = 0; i < 5000; ++i) {
    const double d = random.uniform(0.2, 3), h = random.uniform(0.1, 3), ahead = random.uniform(0.01, 2);
    const double sigma = random.uniform(2, 9), off = h - 1;
    const double r = (d * d + off * off - ahead * ahead) / (2 * (ahead - off));
    const Window own{0, -1, sigma, 0, 0, 0, 0}, rival{d, -h, sigma - ahead, 0, 0, 0, 0};
    if (!(r > 1 && r < 1e3) || ahead * ahead > d * d + off * off || own.at(0) > rival.at(0)) continue;
    double low = 0, high = 1e6;  // where they are equally far on the half-edge
    if (own.at(high) < rival.at(high)) continue;
    for (int step = 0; step < 200; ++step) {
      const double middle = 0.5 * (low + high);
      (own.at(middle) < rival.at(middle) ? low : high) = middle;
    }
    if (low > d) continue;
    const Generator g = generator_of({0, -1, sigma, -low, low, 0, 0});
    const Generator left = generator_of({-d, -h, sigma - ahead, -1e3, -low, 0, 0});
    const Generator right = generator_of({d, -h, sigma - ahead, low, 1e3, 0, 0});
    ASSERT_NEAR(lifetime(&left, g, &right), sigma + r, 1e-12 * (sigma + r)) << i;
    ++met;
  }
  EXPECT_GT(met, 500);
}

TEST(SchreiberLifetime, IsWithoutEndIfNothingThreatens) {
  const Generator g = generator_of({0, -1, 3, -0.5, 0.5, 0, 0});
  EXPECT_EQ(lifetime(nullptr, g, nullptr), infinity);
  const Generator left = generator_of({-1, -1, 3, -2, -0.5, 0, 0}), right = generator_of({1, -1, 3, 0.5, 2, 0, 0});
  EXPECT_EQ(lifetime(&left, g, &right), infinity) << "a strip";
  const Generator late_left = generator_of({-1, -1, 3.1, -2, -0.6, 0, 0});
  const Generator late_right = generator_of({1, -1, 3.1, 0.6, 2, 0, 0});
  EXPECT_EQ(lifetime(&late_left, g, &late_right), infinity) << "it widens";
  EXPECT_EQ(lifetime(&late_left, g, nullptr), infinity);
  EXPECT_EQ(lifetime(nullptr, g, &late_right), infinity);
}

/// The neighbour's ray crosses those of one that was behind only above the half-edge.
TEST(SchreiberLifetime, OfOneThatIsBehindOnAllItsHalfEdgeEndsThere) {
  const Generator g = generator_of({-0.5, -1, 0.5, 0.3, 0.5, 0, 0}), left = generator_of({0, -1, 0, -1, 0.6, 0, 0});
  EXPECT_LT(lifetime(&left, g, nullptr), g.at(0.3));
  const Generator mirrored = g.mirrored(1), right = left.mirrored(1);
  EXPECT_LT(lifetime(nullptr, mirrored, &right), g.at(0.3));
}

/// The only neighbour takes its outer ray at last.
TEST(SchreiberLifetime, WithOneNeighbourIsWhereThatReachesTheOuterRay) {
  const Window own{0, -1, 3, -0.5, 0.2, 0, 0};
  Window rival{1, -1, 0, 0.2, 5, 0, 0};
  rival.sigma = own.at(0.2) - std::hypot(0.8, 1);
  for (const double outer : {-0.1, 0.0, 0.1}) {
    const Generator g = generator_of({0, -1, 3, outer, 0.2, 0, 0}), other = generator_of(rival);
    double low = 1, high = 1e3;  // along the outer ray
    for (int step = 0; step < 200; ++step) {
      const double middle = 0.5 * (low + high), px = middle * g.low_x, py = middle * g.low_y - 1;
      (own.to(px, py) < rival.to(px, py) ? low : high) = middle;
    }
    const double expected = high < 999 ? 3 + high : infinity;
    const double key = lifetime(nullptr, g, &other), mirrored_key = [&] {
      const Generator m = g.mirrored(0), o = other.mirrored(0);
      return lifetime(&o, m, nullptr);
    }();
    if (std::isfinite(expected)) {
      EXPECT_NEAR(key, expected, 1e-12 * expected) << outer;
    } else {
      EXPECT_EQ(key, infinity) << outer;
    }
    EXPECT_EQ(key, mirrored_key) << outer;
  }
}

TEST(SchreiberLifetime, OfASliverIsNothing) {
  const Generator g = generator_of({0, -1, 3, 0.5, 0.5, 0, 0});
  EXPECT_EQ(lifetime(nullptr, g, nullptr), 0);
}

/// A child on its parent's ray through it is as near as that all along the ray, not behind it.
TEST(SchreiberLifetime, AChildIsNotKilledByItsParentOnTheirCommonRay) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const ParentAndChild pair = random_parent_and_child(random);
    const Generator left = generator_of(pair.parent), right = generator_of(pair.child);
    ASSERT_EQ(lifetime(&left, right, nullptr), infinity) << i;
    ASSERT_EQ(lifetime(nullptr, left, &right), infinity) << i;
  }
}

/// It keeps its outer ray until the other neighbour comes there.
TEST(SchreiberLifetime, AChildBetweenItsParentAndAnotherEndsOnTheCommonRay) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Window parent{random.uniform(-0.3, 0.3), -1, 2, -3, 0, 0, 0};
    Window child{parent.x * 0.5, -0.5, parent.to(0.5 * parent.x, -0.5), 0, 0.2, 1, 0}, rival{1, -0.5, 0, 0.2, 5, 2, 0};
    rival.sigma = child.at(0.2) - std::hypot(0.8, 0.5);
    const Generator left = generator_of(parent), g = generator_of(child), right = generator_of(rival);
    double low = 0.5, high = 1e6;  // along the common ray
    for (int step = 0; step < 200; ++step) {
      const double middle = 0.5 * (low + high), px = child.x + middle * g.low_x, py = child.y + middle * g.low_y;
      (child.to(px, py) < rival.to(px, py) ? low : high) = middle;
    }
    if (high > 1e3) continue;
    ASSERT_NEAR(lifetime(&left, g, &right), child.sigma + high, 1e-9 * (1 + high)) << i;
  }
}

}  // namespace
}  // namespace geodrome::schreiber::test
