// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/merging.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plugins/solver_merged_windows/trimming.hpp"
#include "tools/shapes/random.hpp"

/// What the proof asks of a merge, over random neighbours on a half-edge of length 1.
namespace geodrome::merged_windows {
namespace {

using shapes::Random;

struct Scene {
  std::vector<Window> windows;
  double delta, sine;
};

/// Windows of which each begins where the one before it ends, with the same L there; images around one place, as after
/// a vertex or behind saddles, or anywhere.
Scene random_scene(Random& random) {
  const std::size_t count = 2 + random.index(6);
  const double away = std::pow(10, random.uniform(-0.5, 3)), spread = std::pow(10, random.uniform(-6, 0));
  std::vector<double> places{0, 1};
  if (random.index(2) == 0) places = {random.uniform(0, 0.4), random.uniform(0.6, 1)};
  for (std::size_t i = 1; i < count; ++i) places.push_back(random.uniform(places[0], places[1]));
  std::sort(places.begin(), places.end());
  const double x = random.uniform(-away, away), y = -away * random.uniform(0.05, 1);
  Scene scene{{}, std::pow(10, random.uniform(-5, -0.3)), random.uniform(0.1, 1)};
  for (std::size_t i = 0; i < count; ++i) {
    Window window{x + away * spread * random.normal(), std::min(-1e-3, y + away * spread * random.normal()),
                  random.index(2) * random.uniform(0, away), places[i], places[i + 1]};
    if (i > 0) window.sigma += scene.windows[i - 1].at(window.low) - window.at(window.low);
    window.slack = random.index(2) * random.uniform(0, 0.6) * scene.delta * window.at(window.low);
    window.origin = 1, window.parent = no_index;
    window.depth = static_cast<std::uint32_t>(1 + random.index(9));
    scene.windows.push_back(window);
  }
  return scene;
}

double slope(const Window& w, double x) { return (x - w.x) / std::hypot(x - w.x, w.y); }

/// Places of a window, those at its ends among them.
std::vector<double> places_of(const Window& w) {
  std::vector<double> places;
  for (int i = 0; i <= 50; ++i) places.push_back(w.low + (w.high - w.low) * i / 50);
  return places;
}

/// Windows [first, last) of a scene that became one.
struct Group {
  std::size_t first, last;
  Window window;
};

/// The groups of a list after a merge.
std::vector<Group> groups_of(Merging& merging, const Scene& scene) {
  std::vector<Window> windows = scene.windows;
  std::vector<Group> groups;
  std::vector<std::pair<std::size_t, std::size_t>> merges;
  merging.merge(
      windows, {1, scene.sine}, [](const Window&, const Window&) { return true; },
      [&](std::size_t first, std::size_t last) {
        merges.emplace_back(first, last);
        return no_index;
      });
  for (std::size_t i = 0, next = 0, merge = 0; i < windows.size(); ++i) {
    const bool is_merged = merge < merges.size() && merges[merge].first == next;
    groups.push_back({next, is_merged ? merges[merge++].second : next + 1, windows[i]});
    next = groups.back().last;
  }
  return groups;
}

void expect_sound(const Scene& scene, const Group& group) {
  const Window& merged = group.window;
  const Window &first = scene.windows[group.first], &last = scene.windows[group.last - 1];
  const double noise = 1e-13 * (std::abs(merged.sigma) + merged.at(merged.low));
  ASSERT_EQ(merged.low, first.low);
  ASSERT_EQ(merged.high, last.high);
  EXPECT_NEAR(merged.at(merged.low), first.at(first.low), noise);
  EXPECT_NEAR(merged.at(merged.high), last.at(last.high), noise);
  EXPECT_LE(slope(merged, merged.low), slope(first, first.low) + 1e-9);
  EXPECT_GE(slope(merged, merged.high), slope(last, last.high) - 1e-9);
  std::uint32_t deepest = 0;
  for (std::size_t i = group.first; i < group.last; ++i) {
    const Window& old = scene.windows[i];
    deepest = std::max<std::uint32_t>(deepest, old.depth);
    for (const double x : places_of(old)) {
      const double l = merged.at(x), drop = old.at(x) - l;
      EXPECT_GE(drop, -noise);
      EXPECT_GE(l + merged.slack, old.at(x) + old.slack - 1e-15 * l);
      EXPECT_LE(merged.slack, scene.delta * l);
      // A mirror: a path back into the face below is shorter if it cuts the corner at x.
      const double m = std::max(std::abs(slope(merged, x)), std::abs(slope(old, x)));
      EXPECT_LE(drop, scene.sine * std::min(x, 1 - x) * (1 - m * m) + 2 * noise);
    }
  }
  EXPECT_EQ(merged.depth, deepest);
}

TEST(Merging, LowersLAndPaysForIt) {
  Random random(5);
  std::size_t merged = 0, several = 0;
  for (int i = 0; i < 20000; ++i) {
    const Scene scene = random_scene(random);
    Merging merging(scene.delta);
    const std::vector<Group> groups = groups_of(merging, scene);
    for (const Group& group : groups) {
      if (group.last == group.first + 1) continue;
      ++merged, several += group.last > group.first + 2;
      expect_sound(scene, group);
      if (HasFailure()) FAIL() << "scene " << i;
    }
    ASSERT_EQ(groups.back().last, scene.windows.size());
  }
  EXPECT_GT(merged, 2000u);
  EXPECT_GT(several, 300u);
}

/// Two windows take a way of their own, which must lead to where lists lead.
TEST(Merging, MakesOfTwoWhatItMakesOfAListOfTwo) {
  Random random(6);
  std::size_t merged = 0, hopeless = 0, refused = 0;
  for (int i = 0; i < 100000; ++i) {
    const Scene scene = random_scene(random);
    if (scene.windows.size() != 2) continue;
    Merging lists(scene.delta), pairs(scene.delta);
    const std::vector<Group> groups = groups_of(lists, scene);
    std::array<Window, 2> two{scene.windows[0], scene.windows[1]};
    const Merging::Seam seam(Pair(two[0], two[1]));
    const bool is_hopeless = pairs.is_hopeless(two[0], two[1], 1, seam);
    const bool done = !is_hopeless && pairs.merge_two(two, {1, scene.sine}, seam);
    ASSERT_EQ(done, groups.size() == 1) << "scene " << i;
    ASSERT_EQ(pairs.counts().tried, lists.counts().tried);
    ASSERT_EQ(pairs.counts().done, lists.counts().done);
    merged += done, hopeless += is_hopeless, refused += !done && !is_hopeless;
    const Window &one = two[0], &other = groups[0].window;
    ASSERT_EQ(one.x, other.x);
    ASSERT_EQ(one.y, other.y);
    ASSERT_EQ(one.sigma, other.sigma);
    ASSERT_EQ(one.high, other.high);
    ASSERT_EQ(one.slack, other.slack);
    ASSERT_EQ(one.depth, other.depth);
  }
  EXPECT_GT(merged, 1000u);
  EXPECT_GT(hopeless, 1000u);
  EXPECT_GT(refused, 50u);
}

/// Likewise with trimming, where they overlap.
TEST(Merging, TrimsTwoAsAListOfTwo) {
  Random random(7);
  std::array<std::size_t, 5> seen{};
  for (int i = 0; i < 100000; ++i) {
    Scene scene = random_scene(random);
    if (scene.windows.size() != 2) continue;
    auto &left = scene.windows[0], &right = scene.windows[1];
    left.high += random.uniform(-0.1, 0.5) * (right.high - left.high);
    right.low -= random.uniform(-0.1, 0.5) * (right.low - left.low);
    if (random.index(10) == 0) std::swap(left.low, right.low), std::swap(left.high, right.high);
    if (random.index(20) == 0) left.high = left.low;
    if (random.index(20) == 0) right.high = right.low;
    WindowList list = scene.windows;
    Trimming lists, pairs;
    lists.trim(list);
    const Remains remains = pairs.settle(left, right);
    ++seen[static_cast<std::size_t>(remains)];
    ASSERT_EQ(remains == Remains::unsettled, !lists.breaks().empty()) << "scene " << i;
    WindowList rest;
    if (remains != Remains::right && remains != Remains::none) rest.push_back(left);
    if (remains != Remains::left && remains != Remains::none) rest.push_back(right);
    ASSERT_EQ(rest.size(), list.size()) << "scene " << i;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      ASSERT_EQ(rest[k].low, list[k].low);
      ASSERT_EQ(rest[k].high, list[k].high);
      ASSERT_EQ(rest[k].x, list[k].x);
    }
    ASSERT_EQ(pairs.dropped(), lists.dropped());
  }
  for (const Remains each : {Remains::both, Remains::left, Remains::right, Remains::none})
    EXPECT_GT(seen[static_cast<std::size_t>(each)], 30u) << static_cast<int>(each);
  EXPECT_GT(seen[static_cast<std::size_t>(Remains::unsettled)], 0u);
}

/// The two sides of a vertex just passed: one image, cut in two.
std::vector<Window> halves() {
  const Window whole{0.4, -7, 2, 0, 1, 0, 1, no_index, no_index};
  std::vector<Window> halves{whole, whole};
  halves[0].high = halves[1].low = 0.3;
  return halves;
}

std::size_t count_after_merge(std::vector<Window> windows, bool may_join, double sine = 0.8) {
  Merging merging(1e-2);
  merging.merge(
      windows, {1, sine}, [=](const Window&, const Window&) { return may_join; },
      [](std::size_t, std::size_t) { return no_index; });
  return windows.size();
}

TEST(Merging, MakesOneOfTheHalvesOfAWindow) {
  Merging merging(1e-6);
  const std::vector<Group> groups = groups_of(merging, {halves(), 1e-6, 0.8});
  ASSERT_EQ(groups.size(), 1u);
  for (const Window& half : halves())
    for (const double x : places_of(half)) EXPECT_NEAR(groups[0].window.at(x), half.at(x), 1e-12);
}

TEST(Merging, KeepsApartWhatMayNotJoin) {
  EXPECT_EQ(count_after_merge(halves(), true), 1u);
  EXPECT_EQ(count_after_merge(halves(), false), 2u);
  EXPECT_EQ(count_after_merge(halves(), true, 0), 2u) << "the face below has no area";
  std::vector<Window> apart = halves();
  apart[1].low = 0.3 + 1e-9;
  EXPECT_EQ(count_after_merge(apart, true), 2u);
  std::vector<Window> from_the_face_below = halves();
  from_the_face_below[1].from_face_below = true;
  EXPECT_EQ(count_after_merge(from_the_face_below, true), 2u);
}

}  // namespace
}  // namespace geodrome::merged_windows
