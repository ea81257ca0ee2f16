// SPDX-License-Identifier: MIT
// One vertex is too far away, but only in searches that do not keep the map: what an audit asks for is right.
#include "geodrome/plugin.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"

namespace {

using namespace geodrome;

class KeptSearch final : public Search, public ShortestPathMap {
 public:
  explicit KeptSearch(std::unique_ptr<Search> right) : right_(std::move(right)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    map_ = &right_->run(sources, request, context);
    values_.assign(map_->vertices().begin(), map_->vertices().end());
    if (request.keep == Keep::targets) values_.back() *= 1.01;
    return *this;
  }
  std::span<const double> vertices() const override { return values_; }
  Distance at(const SurfacePoint& point) const override { return map_->at(point); }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override { map_->path(point, out); }
  std::span<const Counter> counters() const override { return map_->counters(); }

 private:
  std::unique_ptr<Search> right_;
  const ShortestPathMap* map_ = nullptr;
  std::vector<double> values_;
};

class KeptSurface final : public PreparedSurface {
 public:
  explicit KeptSurface(std::unique_ptr<PreparedSurface> right) : right_(std::move(right)) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<KeptSearch>(right_->make_search()); }
  std::size_t bytes() const override { return right_->bytes(); }

 private:
  std::unique_ptr<PreparedSurface> right_;
};

class KeptSolver final : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return std::make_unique<KeptSurface>(right_.prepare(std::move(mesh), context));
  }

 private:
  test::ExactSolver right_;
};

}  // namespace

GEODROME_PLUGIN(KeptSolver, .name = "faulty_kept_targets", .summary = "a faulty solver", .licence = "MIT",
                .provides = geodrome::test::ExactSolver::provides, .factor = geodrome::exact_factor)
