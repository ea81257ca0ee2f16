// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geodrome/many_searches.hpp"
#include "tests/plugins/solvers/fixture.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::test {

/// So many threads; remembers what it was told.
class RowsContext : public QuietContext {
 public:
  explicit RowsContext(unsigned threads = 1) : threads_(threads) {}
  unsigned threads() const noexcept override { return threads_; }
  void log(LogLevel, std::string_view message) override { lines.emplace_back(message); }

  std::vector<std::string> lines;

 private:
  unsigned threads_;
};

/// The vertices that are on a face, as places.
inline std::vector<SurfacePoint> all_vertices(const SurfaceMesh& mesh) {
  std::set<Index> used;
  for (const Triangle& t : mesh.triangles()) used.insert(t.begin(), t.end());
  std::vector<SurfacePoint> places;
  for (const Index v : used) places.push_back(mesh.at_vertex(v));
  return places;
}

/// A surface made ready for a plan, and the same without.
class Planned {
 public:
  Planned(const MeshPtr& mesh, std::vector<SurfacePoint> sources, double radius = infinity,
          const std::string& options = "rows=lists", unsigned threads = 1)
      : mesh_(mesh), sources_(std::move(sources)), solver_(load_solver("chen_han:" + options)), context_(threads) {
    surface_ = solver_.object->prepare(mesh, context_);
    planned_ = solver_.extension<ManySearches>()->prepare(*surface_, {sources_, radius}, context_);
    plain_search_ = surface_->make_search();
    if (planned_) search_ = planned_->make_search();
  }
  explicit Planned(const MeshPtr& mesh) : Planned(mesh, all_vertices(*mesh)) {}

  /// Whether there is something for the plan, and what was told.
  explicit operator bool() const { return planned_ != nullptr; }
  const std::vector<std::string>& lines() const { return context_.lines; }
  std::string told() const { return context_.lines.empty() ? "" : context_.lines.back(); }
  const std::vector<SurfacePoint>& sources() const { return sources_; }
  const PreparedSurface& surface() const { return *planned_; }

  const ShortestPathMap& row(const SurfacePoint& at, const Request& request = {}, double start = 0) {
    return run(*search_, at, request, start);
  }
  const ShortestPathMap& plain(const SurfacePoint& at, const Request& request = {}, double start = 0) {
    return run(*plain_search_, at, request, start);
  }

  /// The largest difference between rows and plain searches, of every `stride`-th source; infinite if a vertex is
  /// reached in one of them alone.
  double worst(const Request& request = {}, std::size_t stride = 1, double start = 0) {
    double worst = 0;
    for (std::size_t i = 0; i < sources_.size(); i += stride)
      worst = std::max(worst, worst_difference(distances(plain(sources_[i], request, start)),
                                               distances(row(sources_[i], request, start))));
    return worst;
  }
  static std::vector<double> distances(const ShortestPathMap& map) {
    return {map.vertices().begin(), map.vertices().end()};
  }

 private:
  const ShortestPathMap& run(Search& search, const SurfacePoint& at, const Request& request, double start) {
    const Source source{at, start};
    return search.run({&source, 1}, request, context_);
  }

  MeshPtr mesh_;
  std::vector<SurfacePoint> sources_;
  Plugin<ShortestPathSolver> solver_;
  RowsContext context_;
  std::unique_ptr<PreparedSurface> surface_, planned_;
  std::unique_ptr<Search> plain_search_, search_;
};

/// The bound that rows keep, relative to the largest distance.
inline constexpr double row_rounding = 1e-12;

inline MeshPtr fuzzed(std::uint64_t seed) { return share(shapes::fuzz_mesh(seed).mesh); }

/// A plane grid of 9 x 9 squares without its middle: paths bend at the corners of the hole, and many tie.
inline MeshPtr grid_with_hole(bool crossed) {
  const MeshPtr grid = shapes::small::plane_grid(9, crossed);
  std::vector<Triangle> rest;
  for (Index f = 0; f < grid->face_count(); ++f) {
    const Vec3 p = (1.0 / 3) * (grid->corners(f)[0] + grid->corners(f)[1] + grid->corners(f)[2]);
    if (std::abs(p.x - 4) > 2 || std::abs(p.y - 5) > 2) rest.push_back(grid->triangles()[f]);
  }
  return shapes::small::make({grid->positions().begin(), grid->positions().end()}, rest);
}

/// Meshes in which paths bend: rough, open, of higher genus, flat but for rounding, in parts, not manifold, unoriented.
inline std::vector<MeshPtr> bending_meshes(std::uint64_t seed) {
  using namespace shapes::small;
  std::vector<MeshPtr> all = random_meshes(seed);
  const MeshPtr hills = terrain(12, 0.8, seed), torus = bumpy_torus(14, 9, 0.15, seed);
  all.insert(all.end(), {hills, torus, both(hills, torus), finned(torus, 7), finned(hills, 5), moebius(12),
                         shaken(moebius(20), 0.05, seed), fan(9, 0.9), seam(6, seed), book(), grid_with_hole(true),
                         grid_with_hole(false)});
  all.push_back(share(shapes::near_flat(12, 0.3, seed)));
  all.push_back(share(shapes::collapsed_faces(14, seed)));
  all.push_back(share(shapes::spiral_corridor(2)));
  all.push_back(share(shapes::needle_cone(12, 3)));
  all.push_back(share(shapes::stretched_waves(12, 60, seed)));
  return all;
}

}  // namespace geodrome::test
