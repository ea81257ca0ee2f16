// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/pairs/pair_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "geodrome/solver_kit/request_checks.hpp"
#include "plugins/solver_aleksandrov/direct_way.hpp"
#include "plugins/solver_aleksandrov/pairs/pair_index.hpp"

namespace geodrome::aleksandrov {
namespace {

/// Portals along cut edges are this many times delta of the mean edge apart, so that pairs ten edges apart need no
/// search; for a small delta pairs must be farther apart, or there would be too many portals.
constexpr double spacing_over_delta = 10, least_spacing = 0.25;

double mean_edge(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    sum += distance(mesh.positions()[mesh.from(h)], mesh.positions()[mesh.to(h)]);
  return sum / static_cast<double>(3 * mesh.face_count());
}

double spacing_for(const SurfaceMesh& mesh, double delta) {
  return mean_edge(mesh) * std::max(least_spacing, spacing_over_delta * delta);
}

/// The mesh multiplied by a power of two, which is exact: what an index holds are floats, and sums of squares are kept
/// from overflow.
MeshPtr scaled(const SurfaceMesh& mesh, int exponent) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh.positions())
    positions.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
  return std::make_shared<const SurfaceMesh>(std::move(positions),
                                             std::vector<Triangle>(mesh.triangles().begin(), mesh.triangles().end()));
}

/// On a mesh whose mean edge is about 1.
class IndexedPairs final : public PairOracle {
 public:
  IndexedPairs(MeshPtr mesh, std::shared_ptr<const Discretization> discretization, double delta, PairIndex index,
               const ShortestPathSolver& exact, RunContext& context)
      : mesh_(std::move(mesh)),
        discretization_(std::move(discretization)),
        delta_(delta),
        index_(std::move(index)),
        prepared_(exact.prepare(mesh_, context)) {}

  double distance(const SurfacePoint& from, const SurfacePoint& to) const override {
    require_on_surface(*mesh_, from, "a point");
    require_on_surface(*mesh_, to, "a point");
    if (mesh_->vertex_at(from) != no_index && mesh_->vertex_at(from) == mesh_->vertex_at(to)) return 0;
    const Bounds bounds = by_corners(corners(from), corners(to));
    double inner = bounds.most;
    if (!(bounds.most <= (1 + delta_) * bounds.least))
      inner = std::min({bounds.most, direct(from, to), searched(from, to, bounds.most)});
    return std::ldexp(inner, -discretization_->surface().exponent());
  }

  void save(std::ostream& out) const override { index_.save(out); }

 private:
  struct Corner {
    Index vertex;
    double distance;
  };

  /// A vertex alone, or the corners of the face, nearest first.
  std::vector<Corner> corners(const SurfacePoint& point) const {
    const Index vertex = mesh_->vertex_at(point);
    if (vertex != no_index) return {{vertex, 0}};
    std::vector<Corner> all;
    const Vec3 at = mesh_->position(point);
    for (const Index v : mesh_->triangles()[point.face])
      all.push_back({v, geodrome::distance(at, mesh_->positions()[v])});
    std::stable_sort(all.begin(), all.end(), [](const Corner& a, const Corner& b) { return a.distance < b.distance; });
    return all;
  }

  /// Until the bounds are near enough: through each corner, and no farther from the points than their corners are.
  Bounds by_corners(const std::vector<Corner>& from, const std::vector<Corner>& to) const {
    Bounds bounds{0, infinity};
    for (const Corner& a : from)
      for (const Corner& b : to) {
        const Bounds between = index_.between(a.vertex, b.vertex);
        bounds.least = std::max(bounds.least, between.least - a.distance - b.distance);
        bounds.most = std::min(bounds.most, between.most + a.distance + b.distance);
        if (bounds.most <= (1 + delta_) * bounds.least) return bounds;
      }
    return bounds;
  }

  /// Straight around a corner: an exact search loses precision between places far nearer to a vertex than their faces
  /// are wide.
  double direct(const SurfacePoint& from, const SurfacePoint& to) const {
    double least = infinity;
    if (mesh_->vertex_at(from) != no_index || mesh_->vertex_at(to) != no_index) return least;
    const SteinerGraph& graph = discretization_->graph();
    const auto located = [&](const SurfacePoint& p) {
      return discretization_->located(discretization_->surface().inner(p));
    };
    const SurfacePoint start = located(from), end = located(to);
    graph.for_each_name(start, [&](const SurfacePoint& p) {
      graph.for_each_name(end,
                          [&](const SurfacePoint& q) { least = std::min(least, direct_way(graph, p, q).distance); });
    });
    return least;
  }

  /// The exact distance, by a search that goes no farther than `most`.
  double searched(const SurfacePoint& from, const SurfacePoint& to, double most) const {
    const Source source{from};
    QuietContext quiet;
    std::unique_ptr<Search> search = take_search();
    const double value =
        search->run({&source, 1}, {.radius = most * (1 + 1e-9), .targets = {&to, 1}, .stop_at_targets = true}, quiet)
            .at(to)
            .value;
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(search));
    return value;
  }

  std::unique_ptr<Search> take_search() const {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        auto search = std::move(idle_.back());
        idle_.pop_back();
        return search;
      }
    }
    return prepared_->make_search();
  }

  MeshPtr mesh_;
  std::shared_ptr<const Discretization> discretization_;  ///< of the mesh that is asked about, in the same units
  double delta_;
  PairIndex index_;
  std::unique_ptr<PreparedSurface> prepared_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Search>> idle_;
};

}  // namespace

std::unique_ptr<PairOracle> make_pair_oracle(std::shared_ptr<const Discretization> discretization, double delta,
                                             const ShortestPathSolver& exact, std::istream* saved,
                                             RunContext& context) {
  const PackedMesh& surface = discretization->surface();
  if (!surface.mesh().face_weights().empty())
    throw CapabilityError("pair queries on weighted surfaces are not supported",
                          "leave the weights out, or ask for distances from sources");
  MeshPtr mesh = scaled(surface.mesh(), surface.exponent());
  PairIndex index = saved ? PairIndex(*mesh, *saved) : PairIndex(mesh, spacing_for(*mesh, delta), exact, context);
  return std::make_unique<IndexedPairs>(std::move(mesh), std::move(discretization), delta, std::move(index), exact,
                                        context);
}

}  // namespace geodrome::aleksandrov
