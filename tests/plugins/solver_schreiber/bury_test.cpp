// SPDX-License-Identifier: MIT
#include "plugins/solver_schreiber/front.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/plugins/solver_schreiber/front_fixture.hpp"

namespace geodrome::schreiber::test {
namespace {

/// No point of the face that a front reaches is farther.
double farthest(const Front& front, double length, const NextEdge& edge) {
  double most = 0;
  front.for_each([&](const Generator& g) { most = std::max({most, g.at(g.low(length)), g.at(g.high(length))}); });
  return most + std::max({length, std::hypot(edge.start.x - length, edge.start.y), std::hypot(edge.end.x, edge.end.y)});
}

class SchreiberBury : public SchreiberFront {
 protected:
  /// Leaves what goes on to the edge, with rays that pass the apex on the right side. False if there is nobody to whom
  /// the apex belongs: then one generator does not part the others.
  bool split(Front& front, const Truth& of_apex, double length, const NextEdge& edge) {
    const auto [x, y] = edge.apex();
    if (!of_apex.is_clear()) return false;
    const auto all = generators_of(front);
    const auto owner = std::find_if(all.begin(), all.end(),
                                    [&](const Generator& g) { return g.origin == of_apex.nearest && g.covers(x, y); });
    if (owner == all.end()) return false;
    const auto place = static_cast<std::size_t>(owner - all.begin());
    if (edge.is_left()) {
      front.split(place + 1);
    } else {
      front = front.split(place);
    }
    for (std::size_t i = front.size(); i-- > 0;) {
      const Generator g = front[i];
      if (edge.is_left() ? !g.has_left(x, y) : !g.has_right(x, y)) editor_.remove(front, i, {{}, length});
    }
    edge.is_left() ? editor_.end_at(front, x, y) : editor_.begin_at(front, x, y);
    expect_no_key_too_large(front);
    return !front.empty();
  }

  /// Moves a front to the next edge and buries its dead.
  Front carried(Front front, double length, const NextEdge& edge, double until) {
    front.move(edge.motion());
    const FrontEditor::Before before{edge.motion().inverse(), length};
    editor_.fit(front, edge.length(), before);
    if (editor_.bury(front, edge.length(), until, before)) editor_.fit(front, edge.length(), before);
    return front;
  }
  void expect_carried(const Front& whole, const std::vector<Window>& windows, double length, const NextEdge& edge,
                      double until, Random& random) {
    const Front front = carried(whole, length, edge, until);
    expect_keys(front, edge.motion().inverse());
    expect_known(front, edge, random, [&](double x, double y) { return truth(windows, x, y); });
  }
  /// Its generators all live, and know all that is shortest; `truth_at` is in the frame before.
  template <class TruthAt>
  void expect_known(const Front& front, const NextEdge& edge, Random& random, TruthAt&& truth_at) {
    const Front trimmed = editor_.trimmed(front, edge.length());
    std::size_t wide = 0;
    front.for_each(
        [&](const Generator& g) { wide += g.high(edge.length()) - g.low(edge.length()) > 1e-12 * edge.length(); });
    EXPECT_GE(trimmed.size(), wide) << "some of them are dead";
    expect_in_order(trimmed, edge.length());
    for (const double place : sample_places(edge.length(), places_of(trimmed, edge.length()), random)) {
      const Truth t = truth_at(edge.at(place).x, edge.at(place).y);
      if (!t.is_clear()) continue;
      ++needed_;
      ASSERT_NEAR(nearest_covering(front, place, 0), t.straight, 1e-13 * t.straight) << place / edge.length();
      ASSERT_NEAR(nearest_covering(trimmed, place, 0), t.straight, 1e-13 * t.straight) << place / edge.length();
    }
  }
  int needed_ = 0;
};

TEST_F(SchreiberBury, LeavesTheLowerEnvelopeOnTheNextEdge) {
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double length = power(random, 0.1, 2);
    const auto windows = seed % 3 == 0 ? many_windows(random, 1 + seed % 30, length)
                                       : random_windows(random, 1 + seed % 9, length, random.uniform(), seed % 2 == 0);
    Front front = envelope(editor_, pool_, windows, length);
    const NextEdge edge = random_next_edge(random, length);
    const double until = farthest(front, length, edge);
    if (!split(front, truth(windows, edge.apex().x, edge.apex().y), length, edge)) continue;
    expect_carried(front, windows, length, edge, until, random);
    expect_carried(front, windows, length, edge, infinity, random);
    if (HasFailure()) return;
  }
  EXPECT_GT(needed_, 20000);
  EXPECT_GT(editor_.counts().events, 1000u);
}

TEST_F(SchreiberBury, LeavesTheLowerEnvelopeOfALongFront) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto windows = many_windows(random, 1200, 1);
    const Front whole = envelope(editor_, pool_, windows, 1);
    EXPECT_FALSE(whole.is_flat());
    for (int i = 0; i < 20; ++i) {
      const NextEdge edge = random_next_edge(random, 1);
      Front front = whole;
      if (!split(front, truth(windows, edge.apex().x, edge.apex().y), 1, edge)) continue;
      expect_carried(front, windows, 1, edge, farthest(whole, 1, edge), random);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(needed_, 1000);
}

/// Images below the first of several half-edges, all in the frame of the last one: lines must cross them all.
struct Sleeve {
  std::vector<Window> windows;
  std::vector<std::pair<Place, Place>> edges;

  void move(const Motion& motion) {
    const auto moved = [&](double& x, double& y) { std::tie(x, y) = motion(x, y); };
    for (Window& w : windows) moved(w.x, w.y);
    for (auto& [p, q] : edges) moved(p.x, p.y), moved(q.x, q.y);
  }
  /// No bent way is shorter than the straight one through the plane. Clear where the nearest of all images is seen.
  Truth operator()(double px, double py) const {
    Truth t;
    for (std::size_t i = 0; i < windows.size(); ++i)
      if (windows[i].to(px, py) < t.straight) t.straight = windows[i].to(px, py), t.nearest = i;
    const Window& w = windows[t.nearest];
    for (const auto& [p, q] : edges) {
      const double at_p = (px - w.x) * (p.y - w.y) - (py - w.y) * (p.x - w.x);
      const double at_q = (px - w.x) * (q.y - w.y) - (py - w.y) * (q.x - w.x);
      if (!(at_p > 1e-9 && at_q < -1e-9)) t.bent = t.straight;
    }
    return t;
  }
};

TEST_F(SchreiberBury, LeavesTheLowerEnvelopeAcrossManyFaces) {
  int faces = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    double length = 1;
    Sleeve sleeve{seed % 2 == 0 ? many_windows(random, 4 + seed % 80, 1)
                                : random_windows(random, 4 + seed % 20, 1, random.uniform(), true),
                  {{{0, 0}, {1, 0}}}};
    Front front = envelope(editor_, pool_, sleeve.windows, length);
    for (int face = 0; face < 8; ++face) {
      const NextEdge edge = random_next_edge(random, length);
      const double until = farthest(front, length, edge);
      if (!split(front, sleeve(edge.apex().x, edge.apex().y), length, edge)) break;
      front = carried(front, length, edge, until);
      expect_known(front, edge, random, sleeve);
      if (HasFailure()) return;
      sleeve.move(edge.motion());
      length = edge.length();
      sleeve.edges.push_back({{0, 0}, {length, 0}});
      ++faces;
    }
  }
  EXPECT_GT(faces, 800);
  EXPECT_GT(needed_, 5000);
  EXPECT_GT(editor_.counts().events, 500u);
}

/// All rays of the first pass the half-edge beyond its end, where it is nearer than the second, which enters on its
/// right but has its part on the left: that one is dead, and then the first is, behind the third.
TEST_F(SchreiberBury, OneBesideTheHalfEdgeEndsItsNeighbour) {
  const Generator first = generator_of({-10, -0.5, 0, 1, 1.2, 1, 1}),
                  second = generator_of({-3, -0.5, 7, 0.4, 1, 2, 2}),
                  third = generator_of({0.5, -1, 9.5, 0.5, 1, 3, 3});
  ASSERT_LT(first.at(1), second.at(1));
  for (const bool mirrored : {false, true}) {
    Front front = editor_.front_of({first, second, third});
    if (mirrored) front = editor_.mirrored(front, 1);
    // They came through a half-edge 0.3 below, from -6 to 1.
    EXPECT_TRUE(editor_.bury(front, 1, 1e9, {{1, 0, mirrored ? 0.0 : 6.0, 0.3}, 7}));
    ASSERT_EQ(front.size(), 1u) << mirrored;
    EXPECT_EQ(front[0].origin, third.origin);
  }
}

TEST_F(SchreiberBury, LooksOnlyAtThoseWhoseKeyIsReached) {
  int dead = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    Random random(seed);
    const auto windows = many_windows(random, 20, 1);
    Front front = envelope(editor_, pool_, windows, 1);
    const NextEdge edge = random_next_edge(random, 1);
    if (!split(front, truth(windows, edge.apex().x, edge.apex().y), 1, edge)) continue;
    const FrontEditor::Before before{edge.motion().inverse(), 1};
    front.move(edge.motion());
    const std::size_t size = front.size();
    EXPECT_FALSE(editor_.bury(front, edge.length(), std::min(1e9, front.least_key() * (1 - 1e-15)), before));
    EXPECT_EQ(front.size(), size);
    const std::uint64_t events = editor_.counts().events;
    const bool died = editor_.bury(front, edge.length(), 1e9, before);
    EXPECT_EQ(died, front.size() < size);
    EXPECT_EQ(editor_.counts().events - events, size - front.size());
    dead += died;
  }
  EXPECT_GT(dead, 50);
}

}  // namespace
}  // namespace geodrome::schreiber::test
