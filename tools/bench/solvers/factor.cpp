// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/factor.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/exactness.hpp"
#include "tools/bench/solvers/fit.hpp"
#include "tools/bench/solvers/runner.hpp"
#include "tools/bench/solvers/surface_points.hpp"
#include "tools/bench/solvers/witness.hpp"

namespace geodrome::bench {
namespace {

/// All digits of a number.
std::string digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::string name_of(const SurfaceMesh& mesh, const SurfacePoint& point) {
  if (const Index vertex = mesh.vertex_at(point); vertex != no_index) return "vertex " + std::to_string(vertex);
  return "face " + std::to_string(point.face) + " (" + digits(point.b[0]) + ", " + digits(point.b[1]) + ", " +
         digits(point.b[2]) + ")";
}

/// What the solver can be asked at: vertices, and the points in faces if it provides them.
std::span<const SurfacePoint> answerable(const Witness& solver, const ExactDistances& exact) {
  const std::span<const SurfacePoint> places(exact.places);
  return solver.provides(Provides::any_point) ? places : places.first(exact.vertices);
}

/// A search that keeps no more than the places, and its time.
double timed_search(Witness& solver, std::span<const Source> sources, const ExactDistances& exact) {
  const auto in_faces = answerable(solver, exact).subspan(exact.vertices);
  const Request request{.targets = in_faces, .keep = Keep::targets};
  return seconds_of([&] { solver.run(sources, request); });
}

/// All that is asked of one solver.
class FactorJudge {
 public:
  FactorJudge(const Plugin<ShortestPathSolver>& solver, const ExactDistances& exact, const FactorOptions& options)
      : plugin_(solver), exact_(exact), options_(options) {
    result_.factor = solver.factor, result_.faces = exact.mesh->face_count();
  }

  FactorResult run() {
    try {
      result_.prepare_seconds =
          seconds_of([&] { solver_ = std::make_unique<Witness>(plugin_, exact_.mesh, options_.seconds); });
      places_ = answerable(*solver_, exact_);
      for (std::size_t s = 0; s < exact_.sources.size(); ++s)
        if (takes(plugin_.info.provides, *exact_.mesh, exact_.sources[s])) judge_search(s);
    } catch (const Error& error) {
      result_.failure = error.what();
    }
    if (!seconds_.empty()) result_.seconds = median(seconds_), result_.exact_seconds = median(exact_seconds_);
    for (const auto& [name, values] : counted_) result_.counters[name] = median(values);
    return result_;
  }

 private:
  void judge_search(std::size_t s) {
    ++result_.searches;
    seconds_.push_back(timed_search(*solver_, exact_.sources[s], exact_)), exact_seconds_.push_back(exact_.seconds[s]);
    for (const Counter& counter : solver_->counters())
      counted_[counter.name].push_back(static_cast<double>(counter.value));
    judge_answers(s);
    if (options_.paths == 0 || !solver_->provides(Provides::paths)) return;
    solver_->run(exact_.sources[s], {.keep = Keep::map});
    judge_answers(s);
    judge_paths(s);
  }

  void judge_answers(std::size_t s) {
    const std::vector<double>& d = exact_.from[s];
    const std::vector<double> found = solver_->at(places_);
    const std::size_t judged = solver_->provides(Provides::factor_any_point) ? found.size() : exact_.vertices;
    note(s, "the distance", add_places(result_.figures, d, found, result_.factor, judged), d, found, {});
    if (!solver_->states_bounds()) return;
    const std::vector<double> bounds = solver_->lower_bounds(places_);
    note(s, "the interval", add_bounds(result_.bounds, d, found, bounds, result_.factor, exact_.vertices), d, found,
         bounds);
  }

  /// From vertices and from points, drawn anew for each search.
  void judge_paths(std::size_t s) {
    shapes::Random random(options_.seed + s);
    const std::size_t points = places_.size() - exact_.vertices;
    std::vector<double> d, found;
    std::vector<MeasuredPath> measured;
    std::vector<std::size_t> from;
    const auto trace = [&](std::size_t i) {
      const double value = solver_->at(places_.subspan(i, 1))[0];
      if (!std::isfinite(value)) return;
      from.push_back(i), d.push_back(exact_.from[s][i]), found.push_back(value);
      measured.push_back(solver_->path(places_[i]));
    };
    for (std::size_t i = 0; i < options_.paths; ++i) {
      trace(random.index(exact_.vertices));
      if (points > 0) trace(exact_.vertices + random.index(points));
    }
    const double scale = largest_finite(exact_.from[s]);
    const FirstBroken first = add_paths(result_.paths, d, found, measured, result_.factor, scale);
    if (first) note(s, "the path", from[*first], d[*first], found[*first], measured[*first].length);
  }

  void note(std::size_t s, const char* what, FirstBroken first, std::span<const double> exact,
            std::span<const double> found, std::span<const double> bounds) {
    if (first) note(s, what, *first, exact[*first], found[*first], bounds.empty() ? 0 : bounds[*first]);
  }

  /// Remembers the first violation; `figure`: l or the length of the path.
  void note(std::size_t s, const char* what, std::size_t place, double d, double found, double figure) {
    if (!result_.where.empty()) return;
    result_.where = what + (" at " + name_of(*exact_.mesh, places_[place])) + ": d " + digits(d) + ", D " +
                    digits(found) + ", l or length " + digits(figure) + ", in search " + std::to_string(s) + " from";
    for (const Source& source : exact_.sources[s])
      result_.where += " " + name_of(*exact_.mesh, source.at) + " + " + digits(source.start);
  }

  const Plugin<ShortestPathSolver>& plugin_;
  const ExactDistances& exact_;
  FactorOptions options_;
  std::unique_ptr<Witness> solver_;
  std::span<const SurfacePoint> places_;
  std::vector<double> seconds_, exact_seconds_;
  std::map<std::string, std::vector<double>> counted_;
  FactorResult result_;
};

}  // namespace

ExactDistances exact_distances(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh,
                               const FactorOptions& options) {
  Witness exact(solver, mesh, options.seconds);
  shapes::Random random(options.seed);
  ExactDistances result{.mesh = mesh};
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    if (mesh->first_half_edge(v) != no_index) result.places.push_back(mesh->at_vertex(v));
  result.vertices = result.places.size();
  for (std::size_t i = 0; i < options.points && exact.provides(Provides::any_point); ++i)
    result.places.push_back(i % 4 == 3 ? random_edge_point(*mesh, random) : random_inner_point(*mesh, random));
  for (std::size_t i = 0; i < options.sources; ++i) {
    std::vector<Source> sources = random_sources(*mesh, i, random);
    if (takes(solver.info.provides, *mesh, sources)) result.sources.push_back(std::move(sources));
  }
  for (const std::vector<Source>& sources : result.sources) {
    result.seconds.push_back(timed_search(exact, sources, result));
    result.from.push_back(exact.at(result.places));
  }
  return result;
}

bool FactorResult::holds() const {
  const bool factor_holds = !std::isfinite(factor) || (figures.above == 0 && figures.shortfall <= value_limit);
  return failure.empty() && factor_holds && bounds.broken() == 0 && paths.broken() == 0;
}

FactorResult judge_factor(const Plugin<ShortestPathSolver>& solver, const ExactDistances& exact,
                          const FactorOptions& options) {
  return FactorJudge(solver, exact, options).run();
}

FactorResult worst_of(std::span<const FactorResult> results) {
  FactorResult worst;
  for (const FactorResult& result : results) {
    worst.factor = result.factor, worst.faces += result.faces, worst.searches += result.searches;
    worst.figures.add(result.figures), worst.bounds.add(result.bounds), worst.paths.add(result.paths);
    if (worst.failure.empty()) worst.failure = result.failure;
  }
  return worst;
}

std::map<std::string, double> exponents_in_delta(std::span<const FactorResult> results) {
  std::map<std::string, std::vector<double>> deltas, values;
  const auto add = [&](const std::string& name, double delta, double value) {
    if (value > 0) deltas[name].push_back(1 / delta), values[name].push_back(value);
  };
  for (const FactorResult& result : results) {
    const double delta = result.factor - 1;
    if (!(delta > 0) || !std::isfinite(delta)) continue;
    add("seconds", delta, result.seconds);
    for (const auto& [name, value] : result.counters) add(name, delta, value);
  }
  std::map<std::string, double> exponents;
  for (const auto& [name, by] : deltas) {
    const double exponent = fitted_exponent(by, values[name]);
    if (std::isfinite(exponent)) exponents[name] = exponent;
  }
  return exponents;
}

}  // namespace geodrome::bench
