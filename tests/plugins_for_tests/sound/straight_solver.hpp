// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "geodrome/plugin.hpp"

/// What plugins of this folder that are run are made of: a solver that measures straight through space.
namespace geodrome::bad {

class StraightSearch : public Search, public ShortestPathMap {
 public:
  StraightSearch(MeshPtr mesh, void (*on_run)()) : mesh_(std::move(mesh)), on_run_(on_run) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request&, RunContext&) override {
    if (on_run_) on_run_();
    values_.assign(mesh_->vertex_count(), std::numeric_limits<double>::infinity());
    for (const Source& source : sources)
      for (std::size_t v = 0; v < values_.size(); ++v)
        values_[v] =
            std::min(values_[v], source.start + geodrome::distance(mesh_->position(source.at), mesh_->positions()[v]));
    return *this;
  }

  std::span<const double> vertices() const override { return values_; }
  Distance at(const SurfacePoint& point) const override {
    const Index vertex = mesh_->vertex_at(point);
    if (vertex == no_index) throw CapabilityError("only vertices can be asked");
    return {values_[vertex], Reach::reached, 0};
  }
  void path(const SurfacePoint&, std::vector<SurfacePoint>&) const override { throw CapabilityError("no paths"); }
  std::span<const Counter> counters() const override { return {}; }

 private:
  MeshPtr mesh_;
  void (*on_run_)();
  std::vector<double> values_;
};

class StraightSurface : public PreparedSurface {
 public:
  StraightSurface(MeshPtr mesh, void (*on_run)()) : mesh_(std::move(mesh)), on_run_(on_run) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<StraightSearch>(mesh_, on_run_); }
  std::size_t bytes() const override { return 0; }

 private:
  MeshPtr mesh_;
  void (*on_run_)();
};

/// `on_run` is called at the start of every search.
template <void (*on_run)() = nullptr>
class StraightSolver : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext&) const override {
    return std::make_unique<StraightSurface>(std::move(mesh), on_run);
  }
};

}  // namespace geodrome::bad
