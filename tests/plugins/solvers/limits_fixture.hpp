// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"

/// A limit, be it a radius or the farthest target, says what is looked for, not how well.
namespace geodrome::test {

inline MeshPtr fuzzed(std::uint64_t seed) { return share(shapes::fuzz_mesh(seed).mesh); }

/// A solver on a mesh, and beside it an exact one that knows no limit. The factor is the judged solver's.
class LimitJudge {
 public:
  LimitJudge(const std::string& solver, const MeshPtr& mesh, double factor = 1)
      : name_(solver), mesh_(mesh), factor_(factor), judged_(load_solver(solver)), exact_(load_solver("chen_han")) {
    surface_ = judged_.object->prepare(mesh, context_), search_ = surface_->make_search();
    exact_surface_ = exact_.object->prepare(mesh, context_), exact_search_ = exact_surface_->make_search();
  }

  /// Draws places in faces, and finds the distances of vertices, which are returned, and of these without a limit.
  const std::vector<double>& truth(const std::vector<Source>& sources, shapes::Random& random) {
    const ShortestPathMap& map = exact_search_->run(sources, {.keep = Keep::map}, context_);
    truth_.assign(map.vertices().begin(), map.vertices().end());
    places_.clear(), truth_of_places_.clear();
    for (int i = 0; i < 30; ++i) {
      const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
      places_.push_back({static_cast<Index>(random.index(mesh_->face_count())), {u, v, 1 - u - v}});
      truth_of_places_.push_back(map.at(places_.back()).value);
    }
    return truth_;
  }

  /// What is within the radius has its distance, what is not has none. Up to a factor, what lies between is either.
  void expect_radius(const std::vector<Source>& sources, double radius) {
    const ShortestPathMap& map = search_->run(sources, {.radius = radius, .targets = places_}, context_);
    for (Index v = 0; v < truth_.size(); ++v) expect_within(radius, map.vertices()[v], truth_[v], v);
    for (Index i = 0; i < places_.size(); ++i)
      expect_within(radius, map.at(places_[i]).value, truth_of_places_[i], static_cast<Index>(truth_.size()) + i);
  }

  /// A run that stops at a target has its distance, and that of everything that is surely nearer.
  void expect_stop(const std::vector<Source>& sources, Index target) {
    const SurfacePoint at = mesh_->at_vertex(target);
    const auto found = search_->run(sources, {.targets = {&at, 1}, .stop_at_targets = true}, context_).vertices();
    expect_distance(found[target], truth_[target], target, infinity);
    for (Index v = 0; v < truth_.size(); ++v)
      if (factor_ * truth_[v] < truth_[target] * (1 - rounding_of_d) || std::isfinite(found[v]))
        expect_distance(found[v], truth_[v], v, truth_[target]);
  }

 private:
  static constexpr double rounding_of_d = 1e-12;

  /// Numbers after those of vertices are of places in faces.
  void expect_within(double radius, double found, double d, Index v) const {
    if (d > radius * (1 + rounding_of_d)) {
      ASSERT_EQ(found, infinity) << where(v, radius);
    } else if (factor_ * d <= radius * (1 - rounding_of_d)) {
      expect_distance(found, d, v, radius);
    } else if (std::isfinite(found)) {
      ASSERT_LE(found, radius) << where(v, radius);
    }
  }
  void expect_distance(double found, double d, Index v, double limit) const {
    ASSERT_GE(found, d * (1 - rounding_of_d)) << where(v, limit);
    ASSERT_LE(found, factor_ * d * (1 + rounding_of_d)) << where(v, limit);
  }
  std::string where(Index v, double limit) const {
    return name_ + ", " + std::to_string(mesh_->face_count()) + " faces, vertex " + std::to_string(v) + ", limit " +
           std::to_string(limit);
  }

  std::string name_;
  MeshPtr mesh_;
  double factor_;
  QuietContext context_;
  Plugin<ShortestPathSolver> judged_, exact_;
  std::unique_ptr<PreparedSurface> surface_, exact_surface_;
  std::unique_ptr<Search> search_, exact_search_;
  std::vector<SurfacePoint> places_;
  std::vector<double> truth_, truth_of_places_;
};

/// One to three sources, at vertices and in faces, some with a start distance.
inline std::vector<Source> sources_for_limits(const MeshPtr& mesh, shapes::Random& random) {
  std::vector<Source> sources(1 + random.index(3));
  for (Source& source : sources) {
    const double u = random.uniform(0, 1), v = random.uniform(0, 1) * (1 - u);
    source.at = {static_cast<Index>(random.index(mesh->face_count())), {1, 0, 0}};
    if (random.index(2) == 0) source.at.b = {u, v, 1 - u - v};
    if (random.index(2) == 0) source.start = random.uniform(0, 3) * norm(mesh->positions()[0] - mesh->positions()[1]);
  }
  return sources;
}

/// Draws sources, and for each draw radii at and beyond the distances of vertices, and targets to stop at.
inline void expect_limits_change_nothing(LimitJudge& judge, const MeshPtr& mesh, shapes::Random& random) {
  for (int draw = 0; draw < 4; ++draw) {
    const std::vector<Source> sources = sources_for_limits(mesh, random);
    std::vector<Index> reached;
    const std::vector<double>& d = judge.truth(sources, random);
    for (Index v = 0; v < d.size(); ++v)
      if (std::isfinite(d[v])) reached.push_back(v);
    for (int i = 0; i < 6 && !reached.empty(); ++i) {
      judge.expect_radius(sources, d[reached[random.index(reached.size())]] * random.uniform(1, 1.05));
      judge.expect_stop(sources, reached[random.index(reached.size())]);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

}  // namespace geodrome::test
