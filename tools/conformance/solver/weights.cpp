// SPDX-License-Identifier: MIT
// Weights of faces: values against formulas, paths, the audit.
#include <algorithm>
#include <numbers>

#include "engine/surface/common_face.hpp"
#include "geodrome/engine/audit.hpp"
#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

MeshPtr with_weights(const MeshPtr& mesh, std::vector<double> weights) {
  return std::make_shared<const SurfaceMesh>(std::vector<Vec3>(mesh->positions().begin(), mesh->positions().end()),
                                             std::vector<Triangle>(mesh->triangles().begin(), mesh->triangles().end()),
                                             std::move(weights));
}

/// `weight(centre of the face)`.
template <class Weight>
MeshPtr weighted(const MeshPtr& mesh, Weight&& weight) {
  std::vector<double> weights;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const auto [p, q, r] = mesh->corners(f);
    weights.push_back(weight((p + q + r) / 3));
  }
  return with_weights(mesh, std::move(weights));
}

MeshPtr with_random_weights(const MeshPtr& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return weighted(mesh, [&](const Vec3&) { return 0.5 + 4.5 * uniform(random); });
}

std::vector<double> row(SolverTrial& t, const MeshPtr& mesh, Index from) {
  return copy(Running(t.plugin, mesh).run({{mesh->at_vertex(from)}}).vertices());
}

/// Two half planes that meet at x = 0, where a unit costs `left` and `right`, left being the dearer.
struct HalfPlanes {
  double left, right;

  double cost(const Vec3& p, const Vec3& q) const {
    if (p.x > q.x) return cost(q, p);
    const double dy = std::abs(p.y - q.y);
    if (p.x >= 0) return right * geodrome::distance(p, q);
    if (q.x <= 0) {
      // Straight, or to the border at the critical angle, along it and back.
      const double sine = right / left, cosine = std::sqrt(1 - sine * sine), depth = -p.x - q.x;
      const double by_border = dy * cosine >= depth * sine ? left * depth * cosine + right * dy : infinity;
      return std::min(left * geodrome::distance(p, q), by_border);
    }
    // Fermat: the least over where the border is crossed.
    double low = 0, high = dy;
    const auto through = [&](double y) { return left * std::hypot(p.x, y) + right * std::hypot(q.x, dy - y); };
    for (int step = 0; step < 200; ++step) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (through(a) < through(b) ? high : low) = through(a) < through(b) ? b : a;
    }
    return through(low);
  }
};

void half_planes(SolverTrial& t, const MeshPtr& plane, const HalfPlanes& half, Index step) {
  const MeshPtr mesh = weighted(plane, [&](const Vec3& p) { return p.x < 0 ? half.left : half.right; });
  Running running(t.plugin, mesh);
  for (Index from = 0; from < mesh->vertex_count(); from += step) {
    const auto values = running.run({{mesh->at_vertex(from)}}).vertices();
    for (Index to = 0; to < mesh->vertex_count(); ++to)
      t.distance(values[to], half.cost(mesh->positions()[from], mesh->positions()[to]), 12 * half.left, "from vertex ",
                 from, " to ", to, ", weights ", half.left, " and ", half.right);
  }
}

/// Between vertices the border is reached anywhere, in the second case in corridors of needles.
void refraction(SolverTrial& t) {
  t.needs(Provides::weights);
  const MeshPtr plane = mapped(plane_grid(8, true), [](const Vec3& p) { return p - Vec3{4, 0, 0}; });
  for (const double left : {1.2, 2.0, 10.0}) half_planes(t, plane, {left, 1}, 7);
  const MeshPtr stretched = mapped(plane_grid(6, true), [](const Vec3& p) { return Vec3{p.x - 3, 5 * p.y, 0}; });
  for (const double left : {1.5, 4.0}) half_planes(t, stretched, {left, 1}, 5);
}

void one_weight(SolverTrial& t) {
  t.needs(Provides::weights);
  const MeshPtr mesh = terrain(10, 2, 91), heavy = weighted(mesh, [](const Vec3&) { return 2.5; });
  Running running(t.plugin, heavy), truth(t.reference(), mesh);
  for (const Index from : {0, 47, 99}) {
    const auto values = copy(running.run({{heavy->at_vertex(from)}}).vertices());
    const auto wanted = truth.run({{mesh->at_vertex(from)}}).vertices();
    for (Index to = 0; to < mesh->vertex_count(); ++to)
      t.distance(values[to], 2.5 * wanted[to], 60, "from vertex ", from, " to ", to);
  }
}

void scale(SolverTrial& t) {
  t.needs(Provides::weights);
  const MeshPtr mesh = with_random_weights(terrain(9, 2, 93), 95);
  std::vector<double> weights(mesh->face_weights().begin(), mesh->face_weights().end());
  for (double& weight : weights) weight *= 1024;
  const auto plain = row(t, mesh, 40), values = row(t, with_weights(mesh, std::move(weights)), 40);
  for (Index v = 0; v < mesh->vertex_count(); ++v) t.near(values[v] / 1024, plain[v], rounding * 100, "vertex ", v);
}

/// A dearer face makes no way shorter, and a way over it longer by no more than the face.
void growth(SolverTrial& t) {
  t.needs(Provides::weights);
  const MeshPtr mesh = with_random_weights(bumpy_torus(14, 8, 0.1, 97), 99);
  std::vector<double> weights(mesh->face_weights().begin(), mesh->face_weights().end());
  for (double& weight : weights) weight *= 1.5;
  weights[3] *= 2;
  const auto plain = row(t, mesh, 11), values = row(t, with_weights(mesh, std::move(weights)), 11);
  const double factor = t.factor_or_one();
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    t.at_least(values[v] * factor, 1.5 * plain[v] - rounding * 30, "vertex ", v);
    t.at_most(values[v], 3 * plain[v] * factor + rounding * 30, "vertex ", v);
  }
}

/// Faces at vertex 0 between directions in the plane, in degrees; legs are 1 long.
MeshPtr wedges(const std::vector<double>& directions, std::vector<double> weights) {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<Triangle> triangles;
  for (const double degrees : directions) {
    const double angle = degrees * std::numbers::pi / 180;
    positions.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (Index i = 1; i < directions.size(); ++i) triangles.push_back({0, i, i + 1});
  return with_weights(make(positions, triangles), std::move(weights));
}

/// Ways from a vertex cost in proportion along a ray, as long as they stay between the faces there: a cheap edge serves
/// places near the vertex like others.
void along_rays(SolverTrial& t) {
  t.needs(Provides::weights | Provides::any_point);
  t.needs_factor();
  const MeshPtr meshes[] = {wedges({-60, 0, 5, 10}, {0.01, 1, 1.1}), wedges({0, 10, 25, 40, 80}, {3, 2, 2.5, 0.2}),
                            wedges({-50, 0, 50, 100, 150}, {0.5, 0.02, 4, 1})};
  const double factor = t.plugin.factor * (1 + rounding);
  for (const MeshPtr& mesh : meshes) {
    Running running(t.plugin, mesh);
    const ShortestPathMap& map = running.map({{mesh->at_vertex(0)}});
    for (Index face = 0; face < mesh->face_count(); ++face)
      for (const double share : {0.0, 0.05, 0.5, 0.95}) {
        const auto slope = [&](double away) {
          return map.at({face, {1 - away, share * away, (1 - share) * away}}).value / away;
        };
        const double cone = slope(1e-3);
        for (const double away : {1e-4, 1e-5, 1e-6}) {
          t.at_most(slope(away), factor * cone, "face ", face, ", nearer by ", away / 1e-3);
          t.at_least(factor * slope(away), cone, "face ", face, ", nearer by ", away / 1e-3);
        }
      }
  }
}

void costs_of_paths(SolverTrial& t) {
  t.needs(Provides::weights | Provides::any_point | Provides::paths | Provides::path_is_distance);
  const MeshPtr mesh = with_random_weights(terrain(10, 1.5, 101), 103);
  Running running(t.plugin, mesh);
  const CommonFace common(*mesh);
  const ShortestPathMap& map = running.map({{mesh->at_vertex(5)}, {mesh->at_vertex(77)}});
  std::mt19937_64 random(105);
  std::vector<SurfacePoint> path;
  for (int i = 0; i < 60; ++i) {
    const SurfacePoint point = random_point(*mesh, random);
    map.path(point, path);
    double cost = 0;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
      const auto step = common.straight(path[k], path[k + 1]);
      t.holds(step.has_value(), "a step within a face", "step ", k, " from face ", point.face);
      cost += step.value_or(0);
    }
    t.near(cost, map.at(point).value, rounding * 60, "from face ", point.face);
  }
}

void audited(SolverTrial& t) {
  t.needs(Provides::weights | Provides::any_point | Provides::paths);
  const MeshPtr mesh = with_random_weights(bumpy_torus(14, 8, 0.08, 107), 109);
  Running running(t.plugin, mesh);
  std::vector<Source> sources{{mesh->at_vertex(11)}};
  if (t.has(Provides::start_distances)) sources.push_back({mesh->at_vertex(80), 0.3});
  const AuditResult result = audit(*mesh, sources, running.map(sources), t.plugin.info.provides,
                                   {.factor = t.plugin.factor, .points_per_edge = 3});
  t.holds(result.paths > 0, "some paths are traced");
  t.at_most(result.worst_lipschitz, rounding, result.where);
  t.at_most(result.worst_path, rounding, result.where);
}

}  // namespace

DemandTable weight_demands() {
  return {
      solver_demand<one_weight>("weights.one_for_all", "one weight for all faces is a scale"),
      solver_demand<refraction>("weights.refraction", "between half planes of two weights ways obey Snell's law"),
      solver_demand<scale>("weights.scale", "weights 1024 times as large give distances to match"),
      solver_demand<growth>("weights.growth", "larger weights shorten nothing, and lengthen in proportion at most"),
      solver_demand<along_rays>("weights.near_a_source", "near a source costs grow in proportion along a ray"),
      solver_demand<costs_of_paths>("weights.paths", "paths cost what the distance says"),
      solver_demand<audited>("weights.audit", "no jump on a face, no path of another cost"),
  };
}

}  // namespace geodrome::conformance
