// SPDX-License-Identifier: MIT
#include "engine/checks/interval_audit.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/checks/rounding_scale.hpp"
#include "engine/search/lower_bounds.hpp"
#include "engine/surface/face_weight.hpp"

namespace geodrome {

namespace {

class IntervalAuditor {
 public:
  IntervalAuditor(const SurfaceMesh& mesh, std::span<const double> distances, std::span<const double> bounds,
                  const IntervalTerms& terms)
      : mesh_(mesh), distances_(distances), bounds_(bounds), terms_(terms) {
    result_.scale = RoundingScale(smallest_weight(mesh)).distances(distances).points(mesh.positions()).value();
  }

  IntervalFigures run() {
    for (Index v = 0; v < distances_.size(); ++v) audit_vertex(v);
    for (Index f = 0; f < mesh_.face_count(); ++f) audit_edges(f);
    if (result_.scale > 0) result_.worst /= result_.scale;
    return result_;
  }

 private:
  /// What is no number is the worst.
  void demand(double low, double high, Index vertex) {
    if (low <= high) return;
    const double missed = std::isnan(low - high) ? infinity : low - high;
    if (missed > result_.worst) result_.worst = missed, result_.worst_vertex = vertex;
  }

  void audit_vertex(Index v) {
    const double distance = distances_[v], bound = bounds_[v];
    demand(0, bound, v);
    demand(bound, distance, v);
    if (!std::isfinite(distance)) return;
    if (std::isfinite(terms_.factor)) demand(distance, terms_.factor * bound, v);
    const double share = distance == bound ? 0 : (distance - bound) / bound;
    ++result_.vertices;
    result_.largest = std::max(result_.largest, share), result_.sum += share;
  }

  double upper(Index v) const { return terms_.never_shorter ? distances_[v] : 2 * distances_[v] - bounds_[v]; }

  /// Those of a face that no face before it has, or where faces have weights all three.
  void audit_edges(Index face) {
    const Triangle& corners = mesh_.triangles()[face];
    const double weight = weight_of(mesh_, face);
    for (Index i = 0; i < 3; ++i)
      if (mesh_.twins()[3 * face + i] > 3 * face + i || !mesh_.face_weights().empty())
        audit_edge(corners[i], corners[(i + 1) % 3], weight);
  }

  /// Compares squares: few edges need the root.
  void audit_edge(Index a, Index b, double weight) {
    const double squared = squared_distance(mesh_.positions()[a], mesh_.positions()[b]);
    const auto demand_from = [&](Index from, Index to) {
      if (!std::isfinite(distances_[from])) return;
      const double rise = (bounds_[to] - upper(from)) / weight;
      if (!(rise <= 0 || rise * rise <= squared)) demand(bounds_[to], upper(from) + weight * std::sqrt(squared), to);
    };
    demand_from(a, b), demand_from(b, a);
  }

  const SurfaceMesh& mesh_;
  std::span<const double> distances_, bounds_;
  const IntervalTerms& terms_;
  IntervalFigures result_;
};

}  // namespace

void IntervalFigures::add(const IntervalFigures& row, std::uint64_t number) {
  vertices += row.vertices, sum += row.sum;
  largest = std::max(largest, row.largest), scale = std::max(scale, row.scale);
  if (row.worst > worst) worst = row.worst, worst_row = number, worst_vertex = row.worst_vertex;
}

IntervalFigures audit_intervals(const SurfaceMesh& mesh, std::span<const double> distances,
                                std::span<const double> bounds, const IntervalTerms& terms) {
  return IntervalAuditor(mesh, distances, bounds, terms).run();
}

std::optional<IntervalFigures> audit_intervals(const PreparedSolver& solver, const SurfaceMesh& mesh,
                                               const ShortestPathMap& map) {
  const StatedBounds stated(solver.plugin);
  if (!stated) return std::nullopt;
  std::vector<double> bounds;
  const std::span<const double> distances = cross_boundary(solver.plugin.info, [&] {
    bounds = stated.of_vertices(map, mesh.vertex_count());
    return map.vertices();
  });
  return audit_intervals(mesh, distances, bounds, {solver.plugin.factor, solver.provides(Provides::never_shorter)});
}

}  // namespace geodrome
