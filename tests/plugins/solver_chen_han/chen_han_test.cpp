// SPDX-License-Identifier: MIT
#include <cstring>
#include <string_view>

#include "tests/plugins/solvers/fixture.hpp"
#include "tests/support/same_bytes.hpp"
#include "tests/support/stops_after.hpp"
#include "tools/shapes/hostile.hpp"

/// What the exact solver promises beyond its distances: which windows it carries, how much memory it takes, that no run
/// leaves anything to the next.
namespace geodrome::test {
namespace {

/// A search that stays in use.
class Chen {
 public:
  explicit Chen(const MeshPtr& mesh, const std::string& selection = "chen_han")
      : solver_(load_solver(selection)), mesh_(mesh) {
    QuietContext context;
    prepared_ = solver_.object->prepare(mesh, context);
    search_ = prepared_->make_search();
  }

  std::vector<double> run(Index vertex, const Request& request = {}) {
    QuietContext context;
    return run(vertex, request, context);
  }
  std::vector<double> run(Index vertex, const Request& request, RunContext& context) {
    const Source source{mesh_->at_vertex(vertex), 0};
    map_ = nullptr;
    map_ = &search_->run({&source, 1}, request, context);
    return {map_->vertices().begin(), map_->vertices().end()};
  }
  std::uint64_t counter(std::string_view name) const {
    for (const Counter& c : map_->counters())
      if (name == c.name) return c.value;
    ADD_FAILURE() << "no counter " << name;
    return 0;
  }

 private:
  Plugin<ShortestPathSolver> solver_;
  MeshPtr mesh_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  const ShortestPathMap* map_ = nullptr;
};

/// Saddles everywhere; many windows.
MeshPtr hills() { return share(shapes::terrain(20, 1, 3)); }

std::vector<MeshPtr> meshes() {
  std::vector<MeshPtr> all = random_meshes(21);
  all.push_back(hills());
  all.push_back(share(shapes::near_flat(15, 0.3, 2)));
  return all;
}

/// Ways are the same, but which of two equal windows is dropped first is not: only roundings differ.
TEST(ChenHan, TheFilterChangesNoDistance) {
  for (const MeshPtr& mesh : meshes()) {
    Chen with(mesh), without(mesh, "chen_han:filter=off");
    for (const Index source : {0, 50, 99}) EXPECT_LE(worst_difference(with.run(source), without.run(source)), 1e-12);
  }
}

TEST(ChenHan, TheFilterSavesWindows) {
  for (const MeshPtr& mesh : meshes()) {
    Chen with(mesh), without(mesh, "chen_han:filter=off");
    with.run(0), without.run(0);
    EXPECT_LT(with.counter("windows_propagated"), without.counter("windows_propagated"));
    EXPECT_GT(with.counter("windows_filtered"), 0U);
    EXPECT_EQ(without.counter("windows_filtered"), 0U);
  }
}

/// More windows may be propagated than were created: where lists are merged, one may come out in pieces.
TEST(ChenHan, CountersAgreeWithEachOther) {
  for (const MeshPtr& mesh : meshes())
    for (const char* selection : {"chen_han", "chen_han:filter=off"}) {
      Chen solver(mesh, selection);
      solver.run(0);
      const std::uint64_t propagated = solver.counter("windows_propagated"),
                          passed = solver.counter("half_edges_passed");
      EXPECT_LE(passed, propagated);  // none for nothing
      EXPECT_LE(solver.counter("largest_window_list"), propagated);
      EXPECT_LE(propagated, passed * solver.counter("largest_window_list"));
      EXPECT_GE(solver.counter("vertices_emitted"), 1U);  // the source
    }
}

TEST(ChenHan, CountersAreThoseOfTheLastRunAlone) {
  const MeshPtr mesh = hills();
  Chen fresh(mesh), used(mesh);
  for (const Index source : {7, 300, 11}) used.run(source);
  fresh.run(0), used.run(0);
  for (const char* name : {"windows_created", "windows_propagated", "windows_filtered", "windows_trimmed",
                           "half_edges_passed", "vertices_emitted", "largest_window_list"})
    EXPECT_EQ(used.counter(name), fresh.counter(name)) << name;
}

/// The second time round the same sources everything fits into what the first time left.
TEST(ChenHan, ASearchThatIsUsedAgainDoesNotGrow) {
  const MeshPtr mesh = hills();
  for (const Keep keep : {Keep::targets, Keep::map}) {
    Request request;
    request.keep = keep;
    Chen solver(mesh);
    for (Index source = 0; source < 50; ++source) solver.run(8 * source, request);
    const std::uint64_t bytes = solver.counter("largest_search_bytes");
    for (Index source = 0; source < 50; ++source) {
      solver.run(8 * source, request);
      ASSERT_EQ(solver.counter("largest_search_bytes"), bytes) << "source " << source;
    }
  }
}

/// Windows that wait when a run is stopped go back to where they came from.
TEST(ChenHan, CancelledRunsTakeNoMemoryThatLaterOnesMiss) {
  const MeshPtr mesh = hills();
  Chen solver(mesh);
  solver.run(0);
  const std::uint64_t bytes = solver.counter("largest_search_bytes");
  for (int polls = 1; polls <= 50; ++polls) {
    StopsAfter context(1 + polls % 5);
    EXPECT_THROW(solver.run(0, {}, context), Cancelled);
  }
  solver.run(0);
  EXPECT_EQ(solver.counter("largest_search_bytes"), bytes);
}

TEST(ChenHan, WithoutTheMapItTakesLessMemory) {
  const MeshPtr mesh = hills();
  Chen small(mesh), large(mesh);
  small.run(0);
  Request request;
  request.keep = Keep::map;
  large.run(0, request);
  EXPECT_LT(small.counter("largest_search_bytes"), large.counter("largest_search_bytes") / 2);
}

/// Runs something in between on a search that has been used, and compares with a new one.
template <class Between>
void expect_nothing_left_by(Between&& between) {
  for (const MeshPtr& mesh : meshes()) {
    Chen fresh(mesh), used(mesh);
    used.run(3);
    between(used, mesh);
    EXPECT_TRUE(same_bytes(used.run(0), fresh.run(0)));
  }
}

TEST(ChenHan, GivesTheSameBytesAfterOtherSources) {
  expect_nothing_left_by([](Chen& solver, const MeshPtr&) {
    for (const Index source : {90, 5, 33}) solver.run(source);
  });
}

TEST(ChenHan, GivesTheSameBytesAfterARunThatKeptItsMap) {
  expect_nothing_left_by([](Chen& solver, const MeshPtr&) {
    Request request;
    request.keep = Keep::map;
    solver.run(40, request);
  });
}

TEST(ChenHan, GivesTheSameBytesAfterARunThatWasCancelled) {
  for (const int polls : {0, 1, 2, 4})
    expect_nothing_left_by([&](Chen& solver, const MeshPtr&) {
      StopsAfter context(polls);
      try {
        solver.run(40, {}, context);
      } catch (const Cancelled&) {
      }
    });
}

TEST(ChenHan, GivesTheSameBytesAfterARunThatStoppedEarly) {
  expect_nothing_left_by([](Chen& solver, const MeshPtr& mesh) {
    const SurfacePoint targets[] = {mesh->at_vertex(41), {3, {0.25, 0.25, 0.5}}};
    Request request;
    request.targets = targets;
    request.stop_at_targets = true;
    solver.run(40, request);
    request.radius = 0.2, request.stop_at_targets = false;
    solver.run(40, request);
  });
}

TEST(ChenHan, KeepingTheMapChangesNoByteOfTheDistances) {
  Request request;
  request.keep = Keep::map;
  for (const MeshPtr& mesh : meshes()) {
    Chen plain(mesh), keeping(mesh);
    EXPECT_TRUE(same_bytes(plain.run(0), keeping.run(0, request)));
    EXPECT_EQ(plain.counter("windows_propagated"), keeping.counter("windows_propagated"));
  }
}

/// A vertex halfway to the farthest one.
Index halfway(const std::vector<double>& distances) {
  double farthest = 0;
  for (const double d : distances)
    if (std::isfinite(d)) farthest = std::max(farthest, d);
  Index best = 0;
  for (Index v = 0; v < distances.size(); ++v)
    if (std::abs(distances[v] - farthest / 2) < std::abs(distances[best] - farthest / 2)) best = v;
  return best;
}

TEST(ChenHan, StoppingAtATargetPropagatesFewerWindows) {
  for (const MeshPtr& mesh : meshes()) {
    Chen solver(mesh);
    const std::vector<double> all = solver.run(0);
    const std::uint64_t propagated = solver.counter("windows_propagated");
    const SurfacePoint target = mesh->at_vertex(halfway(all));
    Request request;
    request.targets = {&target, 1};
    request.stop_at_targets = true;
    solver.run(0, request);
    EXPECT_LT(solver.counter("windows_propagated"), propagated);
  }
}

TEST(ChenHan, ARadiusPropagatesFewerWindows) {
  for (const MeshPtr& mesh : meshes()) {
    Chen solver(mesh);
    const std::vector<double> all = solver.run(0);
    const std::uint64_t propagated = solver.counter("windows_propagated");
    Request request;
    request.radius = all[halfway(all)];
    solver.run(0, request);
    EXPECT_LT(solver.counter("windows_propagated"), propagated);
  }
}

TEST(ChenHan, AnUnknownProcessorLevelIsAnErrorOfTheOption) {
  EXPECT_THROW(load_solver("chen_han:simd=avx1024"), OptionError);
}

}  // namespace
}  // namespace geodrome::test
