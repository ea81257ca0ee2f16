// SPDX-License-Identifier: MIT
// Every solver: what may be asked of a search, bit by declared bit, and how it is used again.
#include <algorithm>
#include <thread>

#include "contract/solver_contract.hpp"
#include "engine/report/common_face.hpp"

namespace geodrome::test {
namespace {

class SolverRequests : public SolverContract {
 protected:
  const MeshPtr mesh_ = terrain(11, 1.5, 61);

  std::vector<SurfacePoint> some_points(int count, std::uint64_t seed) const {
    std::mt19937_64 random(seed);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < count; ++i) points.push_back(random_point(*mesh_, random));
    return points;
  }
};

TEST_P(SolverRequests, ASourceIsAtItsStartDistance) {
  Running running(plugin(), mesh_);
  const Distance distance = running.run({{mesh_->at_vertex(30)}}).at(mesh_->at_vertex(30));
  EXPECT_EQ(distance.value, 0);
  EXPECT_EQ(distance.reach, Reach::reached);
  EXPECT_EQ(distance.source, 0u);
}

TEST_P(SolverRequests, ASourceAnywhereIsAtDistanceZero) {
  GEODROME_NEEDS(face_sources | any_point);
  Running running(plugin(), mesh_);
  for (const SurfacePoint& point : some_points(30, 67))
    EXPECT_NEAR(running.map({{point}}).at(point).value, 0, rounding * 15);
}

/// A point on an edge has a name in each face of the edge, a vertex one in each of its faces: all mean the same point.
TEST_P(SolverRequests, TheFaceThatNamesASourceDoesNotMatter) {
  GEODROME_NEEDS(face_sources);
  Running running(plugin(), mesh_);
  for (Index h = 0; h < mesh_->twins().size(); h += 7) {
    const Index twin = mesh_->twins()[h];
    if (twin == no_index) continue;
    for (const double t : {0.0, 0.2, 0.5}) {
      SurfacePoint here{h / 3, {}}, there{twin / 3, {}};
      here.b[h % 3] = 1 - t, here.b[(h + 1) % 3] = t;
      there.b[(twin + 1) % 3] = 1 - t, there.b[twin % 3] = t;
      const auto values = copy(running.run({{here}}).vertices());
      const auto other = running.run({{there}}).vertices();
      for (std::size_t v = 0; v < values.size(); ++v)
        ASSERT_NEAR(values[v], other[v], rounding * 15) << "half-edge " << h;
    }
  }
}

TEST_P(SolverRequests, ManySourcesGiveTheNearest) {
  Running running(plugin(), mesh_);
  const std::vector<Source> sources{{mesh_->at_vertex(3)}, {mesh_->at_vertex(77)}, {mesh_->at_vertex(140)}};
  std::vector<std::vector<double>> alone;
  for (const Source& source : sources) alone.push_back(copy(running.run({source}).vertices()));
  const ShortestPathMap& map = running.run(sources);
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    const double nearest = std::min({alone[0][v], alone[1][v], alone[2][v]});
    expect_distance(map.vertices()[v], nearest, 15, "vertex");
    const Index source = map.at(mesh_->at_vertex(v)).source;
    ASSERT_LT(source, 3u);
    EXPECT_LE(alone[source][v], (std::isfinite(plugin().factor) ? plugin().factor : 1) * nearest + rounding * 15);
  }
}

TEST_P(SolverRequests, TheFirstOfTwoSourcesAtOnePlaceIsNamed) {
  Running running(plugin(), mesh_);
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(50)}, {mesh_->at_vertex(50)}});
  for (Index v = 0; v < mesh_->vertex_count(); ++v) ASSERT_EQ(map.at(mesh_->at_vertex(v)).source, 0u) << v;
}

TEST_P(SolverRequests, StartDistancesAreAdded) {
  GEODROME_NEEDS(start_distances);
  Running running(plugin(), mesh_);
  const auto plain = copy(running.run({{mesh_->at_vertex(20)}}).vertices());
  const auto late = copy(running.run({{mesh_->at_vertex(20), 2.5}}).vertices());
  for (std::size_t v = 0; v < plain.size(); ++v) EXPECT_NEAR(late[v], plain[v] + 2.5, rounding * 15);
}

TEST_P(SolverRequests, ALateSourceIsReachedFromAnEarlierOne) {
  GEODROME_NEEDS(start_distances);
  Running running(plugin(), mesh_);
  const double apart = running.run({{mesh_->at_vertex(20)}}).vertices()[21];
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(20)}, {mesh_->at_vertex(21), 100}});
  EXPECT_NEAR(map.vertices()[21], apart, rounding * 15);
  EXPECT_EQ(map.at(mesh_->at_vertex(21)).source, 0u);
}

TEST_P(SolverRequests, ARadiusCutsOffAndSaysSo) {
  GEODROME_NEEDS(radius_limit);
  Running running(plugin(), mesh_);
  const auto all = copy(running.run({{mesh_->at_vertex(60)}}).vertices());
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(60)}}, {.radius = 4});
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    const Distance distance = map.at(mesh_->at_vertex(v));
    EXPECT_EQ(distance.value, map.vertices()[v]);
    EXPECT_EQ(map.vertices()[v], all[v] <= 4 ? all[v] : infinity) << v;
    EXPECT_EQ(distance.reach, all[v] <= 4 ? Reach::reached : Reach::beyond_limit) << v;
  }
}

TEST_P(SolverRequests, TargetsAreKept) {
  GEODROME_NEEDS(any_point);
  Running running(plugin(), mesh_);
  const std::vector<SurfacePoint> targets = some_points(40, 71);
  std::vector<double> wanted;
  const ShortestPathMap& full = running.map({{mesh_->at_vertex(9)}});
  for (const SurfacePoint& target : targets) wanted.push_back(full.at(target).value);
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(9)}}, {.targets = targets});
  for (std::size_t i = 0; i < targets.size(); ++i) EXPECT_NEAR(map.at(targets[i]).value, wanted[i], rounding * 15) << i;
}

TEST_P(SolverRequests, WhatWasNotKeptIsRefused) {
  GEODROME_NEEDS(any_point | paths);
  Running running(plugin(), mesh_);
  const SurfacePoint target{0, {0.25, 0.25, 0.5}}, other{0, {0.5, 0.25, 0.25}};
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(9)}}, {.targets = {&target, 1}});
  std::vector<SurfacePoint> path;
  EXPECT_NO_THROW(map.at(target));
  EXPECT_THROW(map.at(other), CapabilityError);
  EXPECT_THROW(map.path(target, path), CapabilityError);
}

TEST_P(SolverRequests, APointOffTheMeshIsRefused) {
  GEODROME_NEEDS(any_point);
  Running running(plugin(), mesh_);
  const ShortestPathMap& map = running.map({{mesh_->at_vertex(9)}});
  EXPECT_THROW(map.at({static_cast<Index>(mesh_->face_count()), {1, 0, 0}}), InputError);
  EXPECT_THROW(map.at({0, {-0.5, 1, 0.5}}), InputError);
  EXPECT_THROW(map.at({0, {infinity, 0, 0}}), InputError);
}

TEST_P(SolverRequests, StoppingAtTargetsChangesNoTarget) {
  GEODROME_NEEDS(target_limit | any_point);
  Running running(plugin(), mesh_);
  const ShortestPathMap& full = running.map({{mesh_->at_vertex(0)}});
  const std::vector<SurfacePoint> targets{mesh_->at_vertex(26), {40, {0.2, 0.3, 0.5}}, {45, {0, 0.3, 0.7}}};
  std::vector<double> wanted;
  for (const SurfacePoint& target : targets) wanted.push_back(full.at(target).value);
  const auto all = copy(full.vertices());
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(0)}}, {.targets = targets, .stop_at_targets = true});
  for (std::size_t i = 0; i < targets.size(); ++i) EXPECT_NEAR(map.at(targets[i]).value, wanted[i], rounding * 15) << i;
  for (Index v = 0; v < all.size(); ++v) {
    const Distance distance = map.at(mesh_->at_vertex(v));
    if (distance.reach == Reach::reached) {
      EXPECT_NEAR(distance.value, all[v], rounding * 15) << v;
    } else {
      EXPECT_EQ(distance.reach, Reach::beyond_limit) << v;
    }
  }
}

TEST_P(SolverRequests, StoppingAtTargetsSavesWork) {
  GEODROME_NEEDS(target_limit);
  Running running(plugin(), mesh_);
  const SurfacePoint near = mesh_->at_vertex(1);
  const ShortestPathMap& map = running.run({{mesh_->at_vertex(0)}}, {.targets = {&near, 1}, .stop_at_targets = true});
  EXPECT_TRUE(std::any_of(map.vertices().begin(), map.vertices().end(), [](double d) { return d == infinity; }));
}

TEST_P(SolverRequests, PathsRunOnTheSurfaceFromThePointToItsSource) {
  GEODROME_NEEDS(paths | any_point | face_sources);
  Running running(plugin(), mesh_);
  const CommonFace common(*mesh_);
  const std::vector<SurfacePoint> at = some_points(3, 73);
  const ShortestPathMap& map = running.map({{at[0]}, {at[1]}, {at[2]}});
  std::vector<SurfacePoint> path;
  for (const SurfacePoint& point : some_points(80, 79)) {
    map.path(point, path);
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.front(), point);
    EXPECT_NEAR(common.straight(path.back(), at[map.at(point).source]).value_or(1), 0, rounding);
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto step = common.straight(path[i], path[i + 1]);
      ASSERT_TRUE(step) << "step " << i << " leaves the surface";
      length += *step;
    }
    if (has(path_is_distance)) {
      EXPECT_NEAR(length, map.at(point).value, rounding * 15);
    } else {
      EXPECT_GE(length, map.at(point).value - rounding * 15);
    }
  }
}

TEST_P(SolverRequests, ThereIsNoPathFromAnotherComponent) {
  GEODROME_NEEDS(paths);
  const MeshPtr mesh = both(mesh_, mapped(mesh_, [](const Vec3& p) { return p + Vec3{0, 0, 50}; }));
  Running running(plugin(), mesh);
  std::vector<SurfacePoint> path{{0, {1, 0, 0}}};
  running.map({{mesh->at_vertex(0)}}).path(mesh->at_vertex(static_cast<Index>(mesh_->vertex_count())), path);
  EXPECT_TRUE(path.empty());
}

TEST_P(SolverRequests, ASearchUsedAgainGivesTheSameBytes) {
  Running used(plugin(), mesh_);
  for (const Index v : {3, 99, 40}) used.run({{mesh_->at_vertex(v)}}, {.keep = v == 99 ? Keep::map : Keep::targets});
  const auto again = copy(used.run({{mesh_->at_vertex(70)}}).vertices());
  EXPECT_TRUE(same_bytes(again, Running(plugin(), mesh_).run({{mesh_->at_vertex(70)}}).vertices()));
}

TEST_P(SolverRequests, TwoThreadsGiveTheSameBytesAsOne) {
  QuietContext context;
  const auto prepared = plugin().object->prepare(mesh_, context);
  const auto rows = [&](Index first) {
    std::vector<double> all;
    const auto search = prepared->make_search();
    QuietContext own;
    for (Index v = first; v < first + 20; ++v) {
      const Source source{mesh_->at_vertex(v)};
      const auto values = search->run({&source, 1}, {}, own).vertices();
      all.insert(all.end(), values.begin(), values.end());
    }
    return all;
  };
  std::vector<double> a, b;
  std::thread one([&] { a = rows(0); }), two([&] { b = rows(10); });
  one.join(), two.join();
  EXPECT_TRUE(same_bytes(a, rows(0)));
  EXPECT_TRUE(same_bytes(b, rows(10)));
}

TEST_P(SolverRequests, ACancelledRunThrows) {
  Running running(plugin(), mesh_);
  CancelAfter at_once(0);
  const Source source{mesh_->at_vertex(0)};
  EXPECT_THROW(running.search->run({&source, 1}, {}, at_once), Cancelled);
}

TEST_P(SolverRequests, ASearchWorksAfterBeingCancelled) {
  Running running(plugin(), mesh_);
  CancelAfter at_once(0);
  const Source source{mesh_->at_vertex(0)};
  EXPECT_THROW(running.search->run({&source, 1}, {}, at_once), Cancelled);
  const auto values = running.run({source}).vertices();
  EXPECT_TRUE(same_bytes(values, Running(plugin(), mesh_).run({source}).vertices()));
}

TEST_P(SolverRequests, NoSourceIsRefused) {
  Running running(plugin(), mesh_);
  EXPECT_THROW(running.run({}), Error);
}

TEST_P(SolverRequests, APreparedSurfaceSaysWhatItHolds) { EXPECT_GT(Running(plugin(), mesh_).prepared->bytes(), 0u); }

INSTANTIATE_TEST_SUITE_P(Every, SolverRequests, testing::ValuesIn(discovered<ShortestPathSolver>()), plugin_name);

}  // namespace
}  // namespace geodrome::test
