// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geodrome/lower_bounds.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "tools/conformance/demand_table.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::conformance {

using namespace shapes::small;

inline constexpr double rounding = 1e-12;  ///< relative to the largest distance: what "exact" means in this project

using SolverPlugin = Plugin<ShortestPathSolver>;

/// A search on a mesh with everything it needs kept alive.
struct Running {
  QuietContext context;
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<Search> search;

  Running(const SolverPlugin& plugin, const MeshPtr& mesh)
      : prepared(plugin.object->prepare(mesh, context)), search(prepared->make_search()) {}

  const ShortestPathMap& run(const std::vector<Source>& sources, const Request& request = {}) {
    return search->run(sources, request, context);
  }
  const ShortestPathMap& map(const std::vector<Source>& sources) { return run(sources, {.keep = Keep::map}); }
};

inline std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

inline bool same_bytes(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

inline double largest_finite(std::span<const double> values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

/// Is cancelled after it was asked so often.
class CancelAfter : public QuietContext {
 public:
  explicit CancelAfter(int polls) : left_(polls) {}
  bool cancelled() const noexcept override { return left_-- <= 0; }

 private:
  mutable int left_;
};

/// Allows so many threads.
class Threads : public QuietContext {
 public:
  explicit Threads(unsigned count) : count_(count) {}
  unsigned threads() const noexcept override { return count_; }

 private:
  unsigned count_;
};

/// A trial of a solver.
struct SolverTrial : StageTrial<ShortestPathSolver> {
  using StageTrial::StageTrial;

  bool has(Provides bits) const { return geodrome::has(plugin.info.provides, bits); }
  bool exact() const { return plugin.factor == 1; }
  bool has_factor() const { return std::isfinite(plugin.factor); }
  /// For sums and comparisons of several distances, each of which may be too long by the factor.
  double factor_or_one() const { return has_factor() ? plugin.factor : 1; }

  /// Whether distances may change within a guarantee where only rounding, numbering or start distances do.
  bool approximates() const { return !exact() && (has_factor() || plugin.extension<LowerBounds>() != nullptr); }

  void needs(Provides bits) const {
    std::string missing;
    for (const std::string& word : words_of(bits & ~plugin.info.provides))
      missing += (missing.empty() ? "" : ", ") + word;
    if (!missing.empty()) throw NotApplicable{"the solver does not provide " + missing};
  }
  bool fits(const SurfaceMesh& mesh) const {
    const auto needed = [this](Needs bit) { return geodrome::has(plugin.info.needs, bit); };
    return (!needed(Needs::manifold) || mesh.manifold()) && (!needed(Needs::oriented) || mesh.oriented()) &&
           (!needed(Needs::closed) || mesh.closed());
  }
  void needs_fit(const MeshPtr& mesh) const {
    if (!fits(*mesh)) throw NotApplicable{"the solver states that it needs another kind of mesh"};
  }
  void needs_factor() const {
    if (!has_factor()) throw NotApplicable{"the solver states no factor"};
  }

  /// `value` must be a distance of this solver where the true one is `truth`; errors are relative to `scale`.
  template <class... Where>
  void distance(double value, double truth, double scale, const Where&... where) {
    if (has(Provides::never_shorter))
      at_least(value, truth - rounding * scale, "shorter than the truth: ", where...);
    else
      holds(truth == infinity ? value == infinity : std::isfinite(value) && value >= 0,
            "finite and not negative where reachable, infinite elsewhere", where...);
    if (has_factor())
      at_most(value, plugin.factor * truth + rounding * scale, "longer than the factor allows: ", where...);
  }

  /// Two answers for one distance, which an approximation may give anew each time, within its factor.
  template <class... Where>
  void same_distance(double found, double expected, double scale, const Where&... where) {
    if (!approximates()) return near(found, expected, rounding * scale, where...);
    if (!has_factor()) return;
    at_most(found, plugin.factor * expected + rounding * scale, where...);
    at_least(plugin.factor * found, expected - rounding * scale, where...);
  }

  /// The exact solvers at hand, other than the one under judgement, best first.
  std::vector<SolverPlugin> exact_solvers() const {
    std::vector<SolverPlugin> solvers;
    for (const char* name : {"cgal", "chen_han", "schreiber"}) {
      if (plugin.info.name == name) continue;
      try {
        solvers.push_back(host.load<ShortestPathSolver>(name));
      } catch (const OptionError&) {  // not built
      }
    }
    return solvers;
  }
  /// The best of them, that solves `mesh`.
  SolverPlugin reference() const {
    std::vector<SolverPlugin> solvers = exact_solvers();
    if (solvers.empty()) throw NotApplicable{"there is no exact solver to compare with"};
    return solvers.front();
  }
};

template <void (*judge_it)(SolverTrial&)>
constexpr JudgedDemand solver_demand(const char* name, const char* sentence) {
  return demand<SolverTrial, judge_it>(name, sentence);
}

}  // namespace geodrome::conformance
