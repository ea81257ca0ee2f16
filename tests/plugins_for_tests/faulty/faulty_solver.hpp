// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "geodrome/plugin.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"

/// An exact solver with one fault built in, for tests of the conformance kit: it must find each.
namespace geodrome::faulty {

/// What a fault may change; each hides what it needs to.
struct NoFault {
  /// The mesh that is solved instead; the first vertices and faces must be those of the mesh.
  static MeshPtr mesh(MeshPtr mesh) { return mesh; }
  static void before_run(const SurfaceMesh&) {}
  static void sources(std::vector<Source>&) {}
  static double at_vertex(const SurfaceMesh&, std::span<const Source>, Index, double right) { return right; }
  static double value(double right) { return right; }
  static Distance at(const ShortestPathMap&, const SurfaceMesh&, const SurfacePoint&, Distance right) { return right; }
  static void path(std::vector<SurfacePoint>&) {}
  static void counters(std::vector<Counter>&) {}
  static constexpr bool shares_results = false;  ///< between the searches of a surface
};

template <class Fault>
class FaultySearch : public Search, public ShortestPathMap {
 public:
  FaultySearch(MeshPtr mesh, std::unique_ptr<Search> right, std::shared_ptr<std::vector<double>> values)
      : mesh_(std::move(mesh)), right_(std::move(right)), values_(std::move(values)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    Fault::before_run(*mesh_);
    sources_.assign(sources.begin(), sources.end());
    Fault::sources(sources_);
    map_ = &right_->run(sources_, request, context);
    for (Index v = 0; v < values_->size(); ++v)
      (*values_)[v] = Fault::value(Fault::at_vertex(*mesh_, sources_, v, map_->vertices()[v]));
    counters_.assign(map_->counters().begin(), map_->counters().end());
    Fault::counters(counters_);
    return *this;
  }

  std::span<const double> vertices() const override { return *values_; }
  Distance at(const SurfacePoint& point) const override {
    Distance distance = Fault::at(*map_, *mesh_, point, map_->at(point));
    if (const Index vertex = mesh_->vertex_at(point); vertex != no_index)
      distance.value = Fault::at_vertex(*mesh_, sources_, vertex, distance.value);
    distance.value = Fault::value(distance.value);
    return distance;
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override {
    map_->path(point, out);
    Fault::path(out);
  }
  std::span<const Counter> counters() const override { return counters_; }

 private:
  MeshPtr mesh_;
  std::unique_ptr<Search> right_;
  std::shared_ptr<std::vector<double>> values_;
  std::vector<Source> sources_;
  const ShortestPathMap* map_ = nullptr;
  std::vector<Counter> counters_;
};

template <class Fault>
class FaultySurface : public PreparedSurface {
 public:
  FaultySurface(MeshPtr mesh, std::unique_ptr<PreparedSurface> right)
      : mesh_(std::move(mesh)), right_(std::move(right)), shared_(new_values()) {}

  std::unique_ptr<Search> make_search() const override {
    return std::make_unique<FaultySearch<Fault>>(mesh_, right_->make_search(),
                                                 Fault::shares_results ? shared_ : new_values());
  }
  std::size_t bytes() const override { return right_->bytes(); }
  const MeshPtr& mesh() const { return mesh_; }

 private:
  std::shared_ptr<std::vector<double>> new_values() const {
    return std::make_shared<std::vector<double>>(mesh_->vertex_count());
  }

  MeshPtr mesh_;
  std::unique_ptr<PreparedSurface> right_;
  std::shared_ptr<std::vector<double>> shared_;
};

template <class Fault>
class FaultySolver : public ShortestPathSolver {
 public:
  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return std::make_unique<FaultySurface<Fault>>(mesh, right_.prepare(Fault::mesh(mesh), context));
  }

 private:
  test::ExactSolver right_;
};

}  // namespace geodrome::faulty

#define GEODROME_FAULTY_SOLVER(Fault, plugin_name)                                                          \
  GEODROME_PLUGIN(geodrome::faulty::FaultySolver<Fault>, .name = plugin_name, .summary = "a faulty solver", \
                  .licence = "MIT", .provides = geodrome::test::ExactSolver::provides,                      \
                  .factor = geodrome::exact_factor)
