// SPDX-License-Identifier: MIT
// On a share of the faces, drawn with the run's seed, distances are off by a part of themselves, at their vertices too;
// paths are right. By this the power of the audit is measured.
#include <cmath>
#include <random>

#include "geodrome/plugin.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"

namespace {

using namespace geodrome;

struct Settings {
  double error = 1e-6, share = 1e-3;
};

constexpr auto options =
    settings_table(option("error", &Settings::error, "1e-6", -1, 1, "", "of a distance, relative to it"),
                   option("share", &Settings::share, "1e-3", 0, 1, "", "of the faces"));

/// What is wrong with a surface: shared by its searches.
struct Fault {
  double times = 1;
  std::vector<bool> faces, vertices;
};

class SomeFacesSearch final : public Search, public ShortestPathMap {
 public:
  SomeFacesSearch(MeshPtr mesh, std::unique_ptr<Search> right, std::shared_ptr<const Fault> fault)
      : mesh_(std::move(mesh)), right_(std::move(right)), fault_(std::move(fault)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    map_ = &right_->run(sources, request, context);
    values_.assign(map_->vertices().begin(), map_->vertices().end());
    for (Index v = 0; v < values_.size(); ++v)
      if (fault_->vertices[v]) values_[v] *= fault_->times;
    return *this;
  }
  std::span<const double> vertices() const override { return values_; }
  Distance at(const SurfacePoint& point) const override {
    Distance distance = map_->at(point);
    const Index vertex = mesh_->vertex_at(point);
    if (vertex != no_index ? fault_->vertices[vertex] : fault_->faces[point.face]) distance.value *= fault_->times;
    return distance;
  }
  void path(const SurfacePoint& point, std::vector<SurfacePoint>& out) const override { map_->path(point, out); }
  std::span<const Counter> counters() const override { return map_->counters(); }

 private:
  MeshPtr mesh_;
  std::unique_ptr<Search> right_;
  std::shared_ptr<const Fault> fault_;
  const ShortestPathMap* map_ = nullptr;
  std::vector<double> values_;
};

class SomeFacesSurface final : public PreparedSurface {
 public:
  SomeFacesSurface(MeshPtr mesh, std::unique_ptr<PreparedSurface> right, std::shared_ptr<const Fault> fault)
      : mesh_(std::move(mesh)), right_(std::move(right)), fault_(std::move(fault)) {}
  std::unique_ptr<Search> make_search() const override {
    return std::make_unique<SomeFacesSearch>(mesh_, right_->make_search(), fault_);
  }
  std::size_t bytes() const override { return right_->bytes(); }

 private:
  MeshPtr mesh_;
  std::unique_ptr<PreparedSurface> right_;
  std::shared_ptr<const Fault> fault_;
};

class SomeFacesSolver final : public ShortestPathSolver {
 public:
  explicit SomeFacesSolver(const OptionValues& values) : settings_(options.parsed(values)) {}

  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    auto fault = std::make_shared<Fault>(1 + settings_.error, std::vector<bool>(mesh->face_count()),
                                         std::vector<bool>(mesh->vertex_count()));
    std::mt19937_64 random(context.seed());
    for (Index f = 0; f < mesh->face_count(); ++f) {
      fault->faces[f] = std::ldexp(static_cast<double>(random() >> 11), -53) < settings_.share;
      for (const Index v : mesh->triangles()[f]) fault->vertices[v] = fault->vertices[v] || fault->faces[f];
    }
    return std::make_unique<SomeFacesSurface>(mesh, right_.prepare(mesh, context), std::move(fault));
  }

 private:
  Settings settings_;
  test::ExactSolver right_;
};

}  // namespace

GEODROME_PLUGIN(SomeFacesSolver, .name = "faulty_some_faces", .summary = "a faulty solver", .licence = "MIT",
                .provides = test::ExactSolver::provides, .options = options, .factor = exact_factor)
