// SPDX-License-Identifier: MIT
// Says that it reached what it gives as infinitely far away.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {

using namespace geodrome;

class Infinite final : public bad::StraightSearch {
 public:
  using StraightSearch::StraightSearch;
  Distance at(const SurfacePoint&) const override { return {infinity, Reach::reached, 0}; }
};

class Prepared final : public PreparedSurface {
 public:
  explicit Prepared(MeshPtr mesh) : mesh_(std::move(mesh)) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<Infinite>(mesh_, nullptr); }
  std::size_t bytes() const override { return 0; }

 private:
  MeshPtr mesh_;
};

class Solver final : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<Prepared>(std::move(mesh));
  }
};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "bad_reaches_infinity", .summary = "a bad plugin", .licence = "MIT")
