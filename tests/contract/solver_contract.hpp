// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "support/discovered.hpp"
#include "support/meshes.hpp"

namespace geodrome::test {

using SolverPlugin = Discovered<ShortestPathSolver>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double rounding = 1e-12;  ///< relative to the largest distance: what "exact" means in this project

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

inline bool fits(const SolverPlugin& plugin, const SurfaceMesh& mesh) {
  return (!(plugin.needs & manifold) || mesh.manifold()) && (!(plugin.needs & oriented) || mesh.oriented()) &&
         (!(plugin.needs & closed) || mesh.closed());
}

inline std::vector<double> copy(std::span<const double> values) { return {values.begin(), values.end()}; }

/// Is cancelled after it was asked so often.
class CancelAfter : public QuietContext {
 public:
  explicit CancelAfter(int polls) : left_(polls) {}
  bool cancelled() const noexcept override { return left_-- <= 0; }

 private:
  mutable int left_;
};

inline bool same_bytes(std::span<const double> a, std::span<const double> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// The plugin that exact results are compared with where no formula is known; null in a build without it.
inline const SolverPlugin* reference() {
  static const std::vector<SolverPlugin> all = discovered<ShortestPathSolver>();
  for (const SolverPlugin& plugin : all)
    if (plugin.name == "cgal") return &plugin;
  return nullptr;
}

class SolverContract : public testing::TestWithParam<SolverPlugin> {
 protected:
  const SolverPlugin& plugin() const { return GetParam(); }
  bool has(std::uint64_t bits) const { return plugin().has(bits); }
  bool exact() const { return plugin().factor == 1; }

  /// `value` must be a distance of this plugin where the true one is `truth`; errors are relative to `scale`.
  void expect_distance(double value, double truth, double scale, const char* where = "") const {
    EXPECT_GE(value, truth - rounding * scale) << where << ": shorter than the truth";
    const double factor = plugin().factor;
    if (std::isfinite(factor)) {
      EXPECT_LE(value, factor * truth + rounding * scale) << where << ": longer than the factor allows";
    }
  }
};

#define GEODROME_NEEDS(bits) \
  if (!has(bits)) GTEST_SKIP() << plugin().name << " does not provide this"
#define GEODROME_FITS(mesh) \
  if (!fits(plugin(), *(mesh))) GTEST_SKIP() << plugin().name << " needs another kind of mesh"

inline std::string plugin_name(const testing::TestParamInfo<SolverPlugin>& info) { return info.param.name; }

}  // namespace geodrome::test
