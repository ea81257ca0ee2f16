// SPDX-License-Identifier: MIT
// Distances on surfaces where a formula tells them.
#include <algorithm>
#include <numbers>

#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

/// From every `step`-th vertex to all others, against `truth(from, to)`.
template <class Truth>
void all_pairs(SolverTrial& t, const MeshPtr& mesh, Index step, double scale, Truth&& truth) {
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  for (Index from = 0; from < mesh->vertex_count(); from += step) {
    const auto values = running.run({{mesh->at_vertex(from)}}).vertices();
    for (Index to = 0; to < mesh->vertex_count(); ++to)
      t.distance(values[to], truth(from, to), scale, "from vertex ", from, " to ", to);
  }
}

/// In a convex piece of a plane.
void all_straight(SolverTrial& t, const MeshPtr& mesh, Index step, double scale) {
  all_pairs(t, mesh, step, scale,
            [&](Index a, Index b) { return geodrome::distance(mesh->positions()[a], mesh->positions()[b]); });
}

void plane(SolverTrial& t) { all_straight(t, plane_grid(9), 13, 13); }

void tilted_plane(SolverTrial& t) {
  all_straight(t,
               mapped(plane_grid(9, true),
                      [](const Vec3& p) {
                        return Vec3{p.x, 0.6 * p.y, 0.8 * p.y + 0.3 * p.x};
                      }),
               17, 16);
}

void needles(SolverTrial& t) {
  all_straight(t, mapped(plane_grid(8, true), [](const Vec3& p) { return Vec3{p.x, 1000 * p.y, 0}; }), 20, 8000);
}

void plane_any_point(SolverTrial& t) {
  t.needs(Provides::any_point | Provides::face_sources);
  const MeshPtr mesh = plane_grid(5, true);
  t.needs_fit(mesh);
  std::mt19937_64 random(3);
  Running running(t.plugin, mesh);
  for (int k = 0; k < 40; ++k) {
    const SurfacePoint from = random_point(*mesh, random);
    const ShortestPathMap& map = running.map({{from}});
    for (int j = 0; j < 40; ++j) {
      const SurfacePoint to = random_point(*mesh, random);
      const double truth = geodrome::distance(mesh->position(from), mesh->position(to)), value = map.at(to).value;
      if (t.has(Provides::never_shorter))
        t.at_least(value, truth - rounding * 7, "shorter than straight, at face ", to.face);
      if (t.has_factor() && t.has(Provides::factor_any_point))
        t.at_most(value, t.plugin.factor * truth + rounding * 7, "at face ", to.face, " from face ", from.face);
      else
        t.holds(std::isfinite(value), "finite", "at face ", to.face);
    }
  }
}

void unfolded_cube(SolverTrial& t) {
  const double by_differing_axes[] = {0, 1, std::sqrt(2), std::sqrt(5)};
  all_pairs(t, cube(), 1, 3, [&](Index a, Index b) {
    const Index axes = a ^ b;
    return by_differing_axes[(axes & 1) + (axes >> 1 & 1) + (axes >> 2)];
  });
}

void unrolled_prism(SolverTrial& t) {
  constexpr Index m = 17, n = 6;
  const double side = 2 * std::sin(std::numbers::pi / m);
  all_pairs(t, prism(m, n, 0.3), 23, 4, [&](Index a, Index b) {
    const int around = std::abs(static_cast<int>(a / (n + 1)) - static_cast<int>(b / (n + 1)));
    const int along = std::abs(static_cast<int>(a % (n + 1)) - static_cast<int>(b % (n + 1)));
    return std::hypot(std::min<int>(around, m - around) * side, along * 0.3);
  });
}

/// On a fan of unit triangles the unfolded angle between two rim points decides: past pi the way leads through the
/// apex.
void rim_pairs(SolverTrial& t, Index m, double angle) {
  all_pairs(t, fan(m, angle), 1, 2, [&](Index a, Index b) {
    if (a == 0 || b == 0) return a == b ? 0.0 : 1.0;
    const int around = std::abs(static_cast<int>(a) - static_cast<int>(b));
    const double turn = std::min<int>(around, static_cast<int>(m) - around) * angle;
    return turn < std::numbers::pi ? 2 * std::sin(turn / 2) : 2;
  });
}

void cones(SolverTrial& t) {
  rim_pairs(t, 5, 0.9);
  rim_pairs(t, 9, 0.4);
  rim_pairs(t, 12, 0.45);
}

void saddles(SolverTrial& t) {
  rim_pairs(t, 8, 1.0471975511965976);
  rim_pairs(t, 10, 0.8);
  rim_pairs(t, 14, 0.45);
}

/// The faces of a grid of n x n squares whose centres `keep` wants.
template <class Keep>
MeshPtr part_of_grid(Index n, Keep&& keep) {
  const MeshPtr grid = plane_grid(n);
  std::vector<Triangle> kept;
  for (Index f = 0; f < grid->face_count(); ++f) {
    const auto [p, q, r] = grid->corners(f);
    if (keep((p + q + r) / 3)) kept.push_back(grid->triangles()[f]);
  }
  return make({grid->positions().begin(), grid->positions().end()}, kept);
}

void reflex_corner(SolverTrial& t) {
  const MeshPtr mesh = part_of_grid(8, [](const Vec3& c) { return c.x < 4 || c.y < 4; });
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const Vec3 corner{4, 4, 0};
  const auto values = running.run({{mesh->at_vertex(8)}}).vertices();  // at (0, 8)
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->first_half_edge(v) == no_index) continue;
    const Vec3 p = mesh->positions()[v];
    const bool seen = p.x <= 4 || p.x + p.y <= 8;
    const double truth =
        seen ? geodrome::distance({0, 8, 0}, p) : geodrome::distance({0, 8, 0}, corner) + geodrome::distance(corner, p);
    t.distance(values[v], truth, 12, "vertex ", v);
  }
}

/// A square hole in a square, seen from a corner of the square: what lies behind is reached around a corner of the
/// hole.
void hole(SolverTrial& t) {
  const MeshPtr mesh = part_of_grid(9, [](const Vec3& c) { return c.x < 3 || c.x > 6 || c.y < 3 || c.y > 6; });
  t.needs_fit(mesh);
  Running running(t.plugin, mesh);
  const auto values = running.run({{mesh->at_vertex(0)}}).vertices();
  const Vec3 corner{6, 3, 0};
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (mesh->first_half_edge(v) == no_index) continue;
    const Vec3 p = mesh->positions()[v];
    const Vec3 below_diagonal{std::max(p.x, p.y), std::min(p.x, p.y), 0};
    const bool hidden = below_diagonal.x >= 6 && below_diagonal.y > 3 && 2 * below_diagonal.y > below_diagonal.x;
    t.distance(values[v], hidden ? norm(corner) + geodrome::distance(corner, below_diagonal) : norm(p), 14, "vertex ",
               v);
  }
}

}  // namespace

DemandTable distance_demands() {
  return {
      solver_demand<plane>("distances.plane", "on a grid of a plane they are lengths of straight lines"),
      solver_demand<tilted_plane>("distances.tilted_plane", "so they are on a sheared grid, tilted in space"),
      solver_demand<needles>("distances.needles", "so they are on a grid of needles, 1 to 1000"),
      solver_demand<plane_any_point>("distances.plane_any_point", "so they are between points in faces and on edges"),
      solver_demand<unfolded_cube>("distances.cube", "on a cube they are lengths over the unfolded sides"),
      solver_demand<unrolled_prism>("distances.prism",
                                    "on the side of a prism they are lengths over the unrolled side"),
      solver_demand<cones>("distances.cones", "around the apex of a cone they are chords of the unfolded fan"),
      solver_demand<saddles>("distances.saddles", "past a saddle vertex they bend at it where its angle is above pi"),
      solver_demand<reflex_corner>("distances.reflex_corner", "they bend at a reflex corner of the boundary"),
      solver_demand<hole>("distances.hole", "they lead around a hole, not across it"),
  };
}

}  // namespace geodrome::conformance
