// SPDX-License-Identifier: MIT
// Threads, reuse, cancellation, memory: what makes a solver fit for jobs that run for hours.
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

MeshPtr usual_mesh(const SolverTrial& t) {
  const MeshPtr mesh = terrain(11, 1.5, 61);
  t.needs_fit(mesh);
  return mesh;
}

/// Rows of twenty vertices from `first` on, by a search of its own. Between the run and the reading of its result the
/// thread steps back, for others to run into it.
std::vector<double> twenty_rows(const PreparedSurface& prepared, const SurfaceMesh& mesh, Index first) {
  std::vector<double> all;
  const auto search = prepared.make_search();
  QuietContext own;
  for (Index v = first; v < first + 20; ++v) {
    const Source source{mesh.at_vertex(v)};
    const auto values = search->run({&source, 1}, {}, own).vertices();
    std::this_thread::yield();
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

void two_threads(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  QuietContext context;
  const auto prepared = t.plugin.object->prepare(mesh, context);
  const std::vector<double> first = twenty_rows(*prepared, *mesh, 0), second = twenty_rows(*prepared, *mesh, 30);
  // Forty times; five times at least, however slow the solver is.
  const auto enough = std::chrono::steady_clock::now() + std::chrono::seconds(3);
  for (int round = 0; round < 5 || (round < 40 && std::chrono::steady_clock::now() < enough); ++round) {
    std::vector<double> a, b;
    const auto work = [&](std::vector<double>& rows, Index from) {
      try {
        rows = twenty_rows(*prepared, *mesh, from);
      } catch (const std::exception&) {  // shows as rows that are missing
      }
    };
    std::thread one([&] { work(a, 0); }), two([&] { work(b, 30); });
    one.join(), two.join();
    t.holds(same_bytes(a, first) && same_bytes(b, second), "the rows that one thread alone gives", "round ", round);
  }
}

/// The same fault as a race between threads, found without one.
void two_searches(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  QuietContext context;
  const auto prepared = t.plugin.object->prepare(mesh, context);
  const auto one = prepared->make_search(), two = prepared->make_search();
  const Source a{mesh->at_vertex(3)}, b{mesh->at_vertex(99)};
  const ShortestPathMap& map = one->run({&a, 1}, {.keep = Keep::map}, context);
  const std::vector<double> before = copy(map.vertices());
  two->run({&b, 1}, {.keep = Keep::map}, context);
  t.holds(same_bytes(before, map.vertices()), "a map stays what it is while another search runs");
  t.equal(map.at(mesh->at_vertex(50)).value, before[50], "vertex 50");
}

void threads_of_prepare(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Threads one(1), four(4);
  const auto a = t.plugin.object->prepare(mesh, one), b = t.plugin.object->prepare(mesh, four);
  t.holds(same_bytes(twenty_rows(*a, *mesh, 5), twenty_rows(*b, *mesh, 5)), "the same bytes with 1 and 4 threads");
}

void used_again(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Running used(t.plugin, mesh);
  for (const Index v : {3, 99, 40}) used.run({{mesh->at_vertex(v)}}, {.keep = v == 99 ? Keep::map : Keep::targets});
  const auto again = copy(used.run({{mesh->at_vertex(70)}}).vertices());
  t.holds(same_bytes(again, Running(t.plugin, mesh).run({{mesh->at_vertex(70)}}).vertices()),
          "a used search gives the bytes of a fresh one");
}

void used_on_a_limit(SolverTrial& t) {
  t.needs(Provides::radius_limit);
  const MeshPtr mesh = usual_mesh(t);
  Running used(t.plugin, mesh);
  used.run({{mesh->at_vertex(3)}}, {.radius = 2});
  const auto again = copy(used.run({{mesh->at_vertex(3)}}).vertices());
  t.holds(same_bytes(again, Running(t.plugin, mesh).run({{mesh->at_vertex(3)}}).vertices()),
          "a limit does not outlast its request");
}

void cancelled(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Running running(t.plugin, mesh);
  CancelAfter at_once(0);
  const Source source{mesh->at_vertex(0)};
  t.throws<Cancelled>([&] { running.search->run({&source, 1}, {}, at_once); }, "a run that is cancelled at once");
  const auto values = running.run({source}).vertices();
  t.holds(same_bytes(values, Running(t.plugin, mesh).run({source}).vertices()), "the search works afterwards");
}

/// On a mesh large enough for any solver to ask a hundred times.
void cancelled_on_the_way(SolverTrial& t) {
  const MeshPtr mesh = bumpy_torus(120, 60, 0.02, 65);
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  CancelAfter soon(100);
  const Source source{mesh->at_vertex(0)};
  try {
    running.search->run({&source, 1}, {}, soon);
    t.holds(!soon.cancelled(), "a run that asked a hundred times stops");
  } catch (const Cancelled&) {
    t.holds(true, "stopped");
  }
}

void progress(SolverTrial& t) {
  class Watch : public QuietContext {
   public:
    void progress(double fraction) override { in_range &= fraction >= 0 && fraction <= 1; }
    bool in_range = true;
  } watch;
  const MeshPtr mesh = usual_mesh(t);
  const auto prepared = t.plugin.object->prepare(mesh, watch);
  const Source source{mesh->at_vertex(0)};
  prepared->make_search()->run({&source, 1}, {}, watch);
  t.holds(watch.in_range, "progress is between 0 and 1");
}

/// Bytes that are allocated and not given back, by whatever code of this process; 0 where another allocator serves it.
std::size_t bytes_in_use() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return 0;
#else
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

/// `work` is done until all is warm, and then many times more; what it keeps each time adds up to more than `slack`.
/// The C library's caches of freed blocks count as in use and may still fill up, but only once: what is kept is kept
/// again.
template <class Work>
void keeps_nothing(SolverTrial& t, Work&& work, int times, const char* what) {
  constexpr double slack = 4096;
  for (int i = 0; i < 20; ++i) work();
  if (bytes_in_use() == 0) throw NotApplicable{"this build counts memory in its own way: its leak check judges that"};
  double kept = infinity;
  for (int round = 0; round < 2 && kept > slack; ++round) {
    const std::size_t before = bytes_in_use();
    for (int i = 0; i < times; ++i) work();
    kept = std::min(kept, static_cast<double>(bytes_in_use()) - static_cast<double>(before));
  }
  t.at_most(kept, slack, "bytes kept after ", times, " ", what);
}

void memory_of_searches(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Running running(t.plugin, mesh);
  std::vector<SurfacePoint> path;
  const auto search = [&] {
    const ShortestPathMap& map = running.run({{mesh->at_vertex(7)}}, {.keep = Keep::map});
    if (t.has(Provides::paths)) map.path(mesh->at_vertex(100), path);
  };
  keeps_nothing(t, search, 200, "searches");
}

void memory_of_surfaces(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  keeps_nothing(
      t, [&] { Running(t.plugin, mesh).run({{mesh->at_vertex(7)}}); }, 200, "surfaces prepared and dropped");
}

/// Snake case: a-z, 0-9 and _, from a letter on.
bool is_counter_name(const char* name) {
  if (name == nullptr || !(*name >= 'a' && *name <= 'z')) return false;
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return std::ranges::all_of(std::string_view(name), allowed);
}

/// Counters are keys of the run report, where they are added up by name.
void counter_names(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  Running running(t.plugin, mesh);
  std::set<std::string> names;
  for (const Counter& counter : running.map({{mesh->at_vertex(7)}}).counters()) {
    const std::string name = counter.name ? counter.name : "(null)";
    t.holds(is_counter_name(counter.name), "a counter named in snake case", name);
    t.holds(names.insert(name).second, "a counter that occurs once", name);
  }
  t.holds(true, "all counters");
}

void bytes_held(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh(t);
  QuietContext context;
  const std::size_t bytes = t.plugin.object->prepare(mesh, context)->bytes();
  t.holds(bytes < (std::size_t{1} << 40), "a plausible number of bytes", bytes);
}

}  // namespace

DemandTable discipline_demands() {
  return {
      solver_demand<two_searches>("discipline.two_searches", "two searches of one surface do not share their results"),
      solver_demand<two_threads>("discipline.two_threads", "two threads give the same bytes as one"),
      solver_demand<threads_of_prepare>("discipline.threads", "the number of threads for preparing changes no byte"),
      solver_demand<used_again>("discipline.used_again", "a search used before gives the same bytes as a new one"),
      solver_demand<used_on_a_limit>("discipline.limits_end", "a radius is forgotten after its request"),
      solver_demand<cancelled>("discipline.cancelled",
                               "a cancelled run throws Cancelled, and the search works afterwards"),
      solver_demand<cancelled_on_the_way>("discipline.cancelled_midway", "a run notices soon that it is cancelled"),
      solver_demand<progress>("discipline.progress", "progress is told as a share"),
      solver_demand<memory_of_searches>("discipline.memory_searches", "repeated searches keep no memory"),
      solver_demand<memory_of_surfaces>("discipline.memory_surfaces", "prepared surfaces give all their memory back"),
      solver_demand<counter_names>("discipline.counter_names", "counters are named in snake case, each once"),
      solver_demand<bytes_held>("discipline.bytes", "a prepared surface tells its size"),
  };
}

}  // namespace geodrome::conformance
