// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/factor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/exactness.hpp"
#include "tools/bench/solvers/fit.hpp"
#include "tools/bench/solvers/runner.hpp"
#include "tools/bench/solvers/surface_points.hpp"
#include "tools/bench/solvers/witness.hpp"

namespace geodrome::bench {
namespace {

void add_excess(FactorFigures& figures, double excess) {
  ++figures.ratios, figures.ratio_sum += excess;
  figures.largest_excess = figures.ratios == 1 ? excess : std::max(figures.largest_excess, excess);
  figures.mean_excess = figures.ratio_sum / static_cast<double>(figures.ratios);
}

/// What the solver can be asked at: vertices, and the points in faces if it provides them.
std::span<const SurfacePoint> answerable(const Witness& solver, const ExactDistances& exact) {
  const std::span<const SurfacePoint> places(exact.places);
  return solver.provides(Provides::any_point) ? places : places.first(exact.vertices);
}

/// A search that keeps no more than the places, and its time.
double timed_search(Witness& solver, const SurfacePoint& source, const ExactDistances& exact) {
  const Source start{source};
  const auto in_faces = answerable(solver, exact).subspan(exact.vertices);
  const Request request{.targets = in_faces, .keep = Keep::targets};
  return seconds_of([&] { solver.run({&start, 1}, request); });
}

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
    result.places.push_back(random_inner_point(*mesh, random));
  for (std::size_t i = 0; i < options.sources; ++i) {
    const bool in_face = i % 2 == 1 && exact.provides(Provides::face_sources);
    result.sources.push_back(in_face ? random_inner_point(*mesh, random) : random_vertex(*mesh, random));
  }
  for (const SurfacePoint& source : result.sources) {
    result.seconds.push_back(timed_search(exact, source, result));
    result.from.push_back(exact.at(result.places));
  }
  return result;
}

void add_places(FactorFigures& figures, std::span<const double> exact, std::span<const double> found, double factor,
                std::size_t judged) {
  const double scale = largest_finite(exact), rounding = value_limit * scale;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double is = exact[i], claimed = found[i];
    ++figures.places, figures.judged += i < judged;
    if (is == claimed && std::isinf(is)) continue;
    if (is > rounding && std::isfinite(is)) add_excess(figures, claimed / is - 1);
    // Without a factor nothing is above it; NaN is.
    if (i < judged && std::isfinite(factor) && !(claimed <= factor * is + rounding)) ++figures.above;
    const bool measurable = std::isfinite(is) && std::isfinite(claimed);
    if (!(claimed >= is))
      figures.shortfall = std::max(figures.shortfall, measurable ? (is - claimed) / scale : infinity);
  }
}

bool FactorResult::holds() const {
  return !std::isfinite(factor) || (figures.above == 0 && figures.shortfall <= value_limit);
}

FactorResult judge_factor(const Plugin<ShortestPathSolver>& solver, const ExactDistances& exact,
                          const FactorOptions& options) {
  FactorResult result{.factor = solver.factor};
  std::unique_ptr<Witness> witness;
  result.prepare_seconds =
      seconds_of([&] { witness = std::make_unique<Witness>(solver, exact.mesh, options.seconds); });
  const auto places = answerable(*witness, exact);
  const std::size_t judged = witness->provides(Provides::factor_any_point) ? places.size() : exact.vertices;
  std::vector<double> seconds, exact_seconds;
  std::map<std::string, std::vector<double>> counted;
  for (std::size_t s = 0; s < exact.sources.size(); ++s) {
    const bool at_vertex = exact.mesh->vertex_at(exact.sources[s]) != no_index;
    if (!at_vertex && !witness->provides(Provides::face_sources)) continue;
    seconds.push_back(timed_search(*witness, exact.sources[s], exact)), exact_seconds.push_back(exact.seconds[s]);
    add_places(result.figures, exact.from[s], witness->at(places), result.factor, judged);
    for (const Counter& counter : witness->counters())
      counted[counter.name].push_back(static_cast<double>(counter.value));
  }
  result.seconds = median(seconds), result.exact_seconds = median(exact_seconds);
  for (const auto& [name, values] : counted) result.counters[name] = median(values);
  return result;
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
