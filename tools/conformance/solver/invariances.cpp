// SPDX-License-Identifier: MIT
// What must hold of distances whatever the surface is.
#include <algorithm>
#include <numeric>

#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

std::vector<double> row(SolverTrial& t, const MeshPtr& mesh, Index from) {
  return copy(Running(t.plugin, mesh).run({{mesh->at_vertex(from)}}).vertices());
}

/// From every `step`-th vertex.
std::vector<std::vector<double>> rows(SolverTrial& t, const MeshPtr& mesh, Index step) {
  Running running(t.plugin, mesh);
  std::vector<std::vector<double>> all;
  for (Index v = 0; v < mesh->vertex_count(); v += step)
    all.push_back(copy(running.run({{mesh->at_vertex(v)}}).vertices()));
  return all;
}

void straight_line(SolverTrial& t) {
  t.needs(Provides::never_shorter);
  const MeshPtr mesh = bumpy_torus(20, 10, 0.1, 13);
  t.needs_fit(mesh);
  const std::vector<double> values = row(t, mesh, 7);
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    t.at_least(values[v], geodrome::distance(mesh->positions()[7], mesh->positions()[v]) * (1 - rounding), "vertex ",
               v);
}

void needs_a_metric(const SolverTrial& t) {
  if (!t.has_factor()) throw NotApplicable{"promised of solvers that state a factor"};
}

void symmetry(SolverTrial& t) {
  needs_a_metric(t);
  const MeshPtr mesh = terrain(10, 2, 17);
  t.needs_fit(mesh);
  const auto all = rows(t, mesh, 15);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double a = all[i][15 * j], b = all[j][15 * i];
      t.at_most(std::max(a, b), t.factor_or_one() * std::min(a, b) + rounding * 30, "vertices ", 15 * i, " and ",
                15 * j);
    }
}

void triangle_inequality(SolverTrial& t) {
  needs_a_metric(t);
  const MeshPtr mesh = bumpy_torus(14, 8, 0.1, 19);
  t.needs_fit(mesh);
  const auto all = rows(t, mesh, 9);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j)
      for (Index v = 0; v < mesh->vertex_count(); ++v)
        t.at_most(all[i][v], t.factor_or_one() * (all[i][9 * j] + all[j][v]) + rounding * 10, "from vertex ", 9 * i,
                  " to ", v, " by ", 9 * j);
}

void scale(SolverTrial& t) {
  const MeshPtr mesh = terrain(10, 2, 23);
  t.needs_fit(mesh);
  const std::vector<double> plain = row(t, mesh, 60);
  for (const double factor : {1e-6, 1e6}) {
    const std::vector<double> values = row(t, mapped(mesh, [=](const Vec3& p) { return factor * p; }), 60);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      t.near(values[v] / factor, plain[v], rounding * 30, "vertex ", v, " at scale ", factor);
  }
}

/// By powers of two nothing is rounded otherwise, until numbers leave the range of doubles when they are squared.
void extreme_scale(SolverTrial& t) {
  const MeshPtr mesh = bumpy_torus(12, 8, 0.1, 27);
  t.needs_fit(mesh);
  const std::vector<double> plain = row(t, mesh, 40);
  for (const double factor : {0x1p-100, 0x1p100}) {
    const std::vector<double> values = row(t, mapped(mesh, [=](const Vec3& p) { return factor * p; }), 40);
    for (Index v = 0; v < mesh->vertex_count(); ++v)
      t.near(values[v] / factor, plain[v], rounding * 5, "vertex ", v, " at scale ", factor);
  }
}

/// The rotation is by (3, 4, 5) / 5 and rounds coordinates by 1e-16 of the extent.
void rotation(SolverTrial& t) {
  if (t.approximates()) throw NotApplicable{"an approximation may differ within its guarantee"};
  const MeshPtr mesh = terrain(10, 2, 29);
  t.needs_fit(mesh);
  const std::vector<double> plain = row(t, mesh, 5);
  const std::vector<double> turned = row(t,
                                         mapped(mesh,
                                                [](const Vec3& p) {
                                                  return Vec3{0.6 * p.x - 0.8 * p.z, p.y, 0.8 * p.x + 0.6 * p.z};
                                                }),
                                         5);
  for (Index v = 0; v < mesh->vertex_count(); ++v) t.near(turned[v], plain[v], rounding * 30, "vertex ", v);
}

/// Vertices in the opposite order, faces too, and every face from its next corner on.
void numbering(SolverTrial& t) {
  if (!t.exact()) throw NotApplicable{"an approximation may depend on the numbering within its factor"};
  const MeshPtr mesh = terrain(9, 2, 33);
  t.needs_fit(mesh);
  const auto last = static_cast<Index>(mesh->vertex_count() - 1);
  std::vector<Vec3> positions(mesh->positions().rbegin(), mesh->positions().rend());
  std::vector<Triangle> triangles;
  for (Index f = static_cast<Index>(mesh->face_count()); f-- > 0;) {
    const auto [a, b, c] = mesh->triangles()[f];
    triangles.push_back({last - b, last - c, last - a});
  }
  const std::vector<double> plain = row(t, mesh, 11), other = row(t, make(positions, triangles), last - 11);
  for (Index v = 0; v <= last; ++v) t.near(other[last - v], plain[v], rounding * 30, "vertex ", v);
}

}  // namespace

DemandTable invariance_demands() {
  return {
      solver_demand<straight_line>("invariances.straight_line", "no distance is below that through space"),
      solver_demand<symmetry>("invariances.symmetry", "D(s,t) = D(t,s), up to the factor"),
      solver_demand<triangle_inequality>("invariances.triangle", "D(s,t) <= D(s,v) + D(v,t), up to the factor"),
      solver_demand<scale>("invariances.scale", "a mesh a million times as large or small has distances to match"),
      solver_demand<extreme_scale>("invariances.extreme_scale", "so has one 2^100 times as large or small"),
      solver_demand<rotation>("invariances.rotation", "a mesh turned in space has the same distances"),
      solver_demand<numbering>("invariances.numbering", "the order of vertices and faces changes no distance"),
  };
}

}  // namespace geodrome::conformance
