// SPDX-License-Identifier: MIT
// Offers ManySearches: its surface for a plan answers as the exact solver, but for a rounding that tells by which plan
// the distances were made.
#include <chrono>
#include <thread>

#include "geodrome/many_searches.hpp"
#include "geodrome/plugin.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"

namespace {

using namespace geodrome;

enum class Answer { surface, null, throws, waits };

struct Settings {
  Answer answer;
};

constexpr auto options =
    settings_table(option("answer", &Settings::answer, "surface", "surface|null|throws|waits",
                          {Answer::surface, Answer::null, Answer::throws, Answer::waits}, "what becomes of a plan"));

/// The exact solver's search with all distances a few roundings longer.
class NudgedSearch final : public Search, public ShortestPathMap {
 public:
  NudgedSearch(std::unique_ptr<Search> exact, double nudge) : exact_(std::move(exact)), nudge_(nudge) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    map_ = &exact_->run(sources, request, context);
    values_.assign(map_->vertices().begin(), map_->vertices().end());
    for (double& value : values_) value *= nudge_;
    counters_.assign(map_->counters().begin(), map_->counters().end());
    counters_.push_back({"planned_searches", 1});
    return *this;
  }

  std::span<const double> vertices() const override { return values_; }
  Distance at(const SurfacePoint& point) const override {
    Distance distance = map_->at(point);
    distance.value *= nudge_;
    return distance;
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override { map_->path(point, out); }
  std::span<const Counter> counters() const override { return counters_; }

 private:
  std::unique_ptr<Search> exact_;
  double nudge_;
  const ShortestPathMap* map_ = nullptr;
  std::vector<double> values_;
  std::vector<Counter> counters_;
};

class PlannedSurface final : public PreparedSurface {
 public:
  /// It refers to the surface that it was made from, as it may.
  PlannedSurface(const PreparedSurface& exact, const SearchPlan& plan)
      : exact_(exact), nudge_(1 + 0x1p-51 * static_cast<double>(1 + plan.sources.size() % 8)) {}

  std::unique_ptr<Search> make_search() const override {
    return std::make_unique<NudgedSearch>(exact_.make_search(), nudge_);
  }
  std::size_t bytes() const override { return exact_.bytes() + 1'000'000; }

 private:
  const PreparedSurface& exact_;
  double nudge_;
};

class Surface final : public PreparedSurface {
 public:
  Surface(std::unique_ptr<PreparedSurface> exact, Answer answer) : exact_(std::move(exact)), answer_(answer) {}

  std::unique_ptr<Search> make_search() const override { return exact_->make_search(); }
  std::size_t bytes() const override { return exact_->bytes(); }

  std::unique_ptr<PreparedSurface> plan(const SearchPlan& plan, RunContext& context) const {
    context.throw_if_cancelled();
    context.measure("planned_sources", static_cast<double>(plan.sources.size()));
    context.measure("planned_radius", plan.radius);
    context.log(LogLevel::info, "a plan came");
    if (answer_ == Answer::throws) throw RefusedError("the plan is too large", "make it smaller");
    for (; answer_ == Answer::waits; std::this_thread::sleep_for(std::chrono::milliseconds(1)))
      context.throw_if_cancelled();
    return answer_ == Answer::surface ? std::make_unique<PlannedSurface>(*exact_, plan) : nullptr;
  }

 private:
  std::unique_ptr<PreparedSurface> exact_;
  Answer answer_;
};

class Solver final : public ShortestPathSolver {
 public:
  explicit Solver(const OptionValues& values) : answer_(options.parsed(values).answer) {}

  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return std::make_unique<Surface>(exact_.prepare(std::move(mesh), context), answer_);
  }

 private:
  test::ExactSolver exact_;
  Answer answer_;
};

constexpr ManySearches many_searches{[](const PreparedSurface& prepared, const SearchPlan& plan, RunContext& context) {
  return static_cast<const Surface&>(prepared).plan(plan, context);
}};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "test_together", .summary = "many searches prepared together", .licence = "MIT",
                .provides = test::ExactSolver::provides, .options = options, .factor = exact_factor,
                .extension = extensions<many_searches>)
