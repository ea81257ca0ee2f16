// SPDX-License-Identifier: MIT
#include "tools/shapes/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geodrome/errors.hpp"
#include "tools/shapes/blue_noise.hpp"
#include "tools/shapes/implicit.hpp"
#include "tools/shapes/implicit_sampler.hpp"
#include "tools/shapes/meshes.hpp"
#include "tools/shapes/patch.hpp"
#include "tools/shapes/radial.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/surface_net.hpp"

namespace geodrome::shapes {
namespace {

struct OrientedPoint {
  Vec3 position, normal;
};
using Draw = std::function<OrientedPoint(Random&)>;

[[noreturn]] void fail_unknown(const std::string& kind, const std::vector<std::string>& kinds) {
  std::string valid;
  for (const std::string& name : kinds) valid += (valid.empty() ? "" : ", ") + name;
  throw OptionError("unknown shape '" + kind + "'", "valid shapes: " + valid);
}

OrientedPoint oriented(const PatchPoint& p) { return {p.position, p.area / norm(p.area)}; }

OrientedPoint oriented(const Implicit& surface, const Vec3& position) {
  const Vec3 gradient = surface.at(position).gradient;
  return {position, gradient / norm(gradient)};
}

/// Draws points that are independent and exactly uniform by area.
Draw uniform_sampler(const std::string& kind) {
  if (const Patch* patch = find_patch(kind))
    return [patch](Random& random) {
      for (;;) {
        const double u = random.uniform(), v = random.uniform();
        const PatchPoint p = patch->at(u, v);
        if (random.uniform() * patch->largest_area < norm(p.area)) return oriented(p);
      }
    };
  return [sampler = ImplicitSampler(*find_implicit(kind))](Random& random) {
    return oriented(sampler.surface(), sampler.draw(random));
  };
}

std::vector<OrientedPoint> draw_uniform(const std::string& kind, std::size_t count, Random& random) {
  const Draw draw = uniform_sampler(kind);
  std::vector<OrientedPoint> points;
  points.reserve(count);
  while (points.size() < count) points.push_back(draw(random));
  return points;
}

std::vector<OrientedPoint> draw_blue(const std::string& kind, std::size_t count, Random& random) {
  constexpr std::size_t candidates_per_point = 5;      // Yuksel's recommendation
  constexpr std::size_t faces_that_tell_area = 20000;  // to well below a percent
  const std::vector<OrientedPoint> candidates = draw_uniform(kind, candidates_per_point * count, random);
  std::vector<Vec3> positions;
  for (const OrientedPoint& p : candidates) positions.push_back(p.position);
  std::vector<OrientedPoint> kept;
  for (Index i : eliminate(positions, count, area(mesh(kind, faces_that_tell_area)))) kept.push_back(candidates[i]);
  return kept;
}

/// A lattice in (u, v): rows at poles stay half a step away, rows at borders lie on them.
std::vector<OrientedPoint> patch_lattice(const Patch& patch, std::size_t count, double jitter, Random& random) {
  const auto at_least = [](double x, double least) { return std::max(std::round(x), least); };
  const double columns = at_least(std::sqrt(static_cast<double>(count) * patch.aspect), 2);
  const double rows = at_least(static_cast<double>(count) / columns, 2);
  const double low = patch.v_low == End::pole ? 0.5 : 0, high = patch.v_high == End::border ? 0
                                                                : patch.v_high == End::pole ? 0.5
                                                                                            : 1;
  const double across = patch.u_wraps ? columns : columns - 1, up = rows - 1 + low + high;
  const auto moved = [&](double place, double step, bool ends) {
    const double to = place + (jitter > 0 ? random.uniform(-jitter, jitter) / step : 0);
    return ends ? std::clamp(to, 0.0, 1.0) : to;
  };
  std::vector<OrientedPoint> points;
  for (double row = 0; row < rows; ++row)
    for (double column = 0; column < columns; ++column) {
      const double u = moved(column / across, across, !patch.u_wraps);
      const double v = moved((row + low) / up, up, patch.v_low != End::wrap);
      points.push_back(oriented(patch.at(u, v)));
    }
  return points;
}

/// On an implicit surface: the vertices of its surface net, one near each cell of a regular grid.
std::vector<OrientedPoint> lattice(const std::string& kind, const SampleSpec& spec, Random& random) {
  if (const Patch* patch = find_patch(kind)) return patch_lattice(*patch, spec.points, spec.jitter, random);
  if (spec.jitter > 0) throw OptionError("the lattice of '" + kind + "' cannot be jittered");
  const Implicit& surface = *find_implicit(kind);
  const SurfaceMesh net = surface_net(surface, 2 * spec.points);
  std::vector<OrientedPoint> points;
  for (const Vec3& p : net.positions()) points.push_back(oriented(surface, p));
  return points;
}

double bounding_box_diagonal(const std::vector<OrientedPoint>& points) {
  Vec3 low = points.front().position, high = low;
  for (const auto& [p, normal] : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

void check(const std::string& kind, const SampleSpec& spec) {
  const auto& kinds = sample_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) fail_unknown(kind, kinds);
  if (spec.points < 4)
    throw OptionError("a sample of " + std::to_string(spec.points) + " points", "ask for at least 4");
  if (!(spec.jitter >= 0 && spec.jitter < 0.5)) throw OptionError("jitter is not a number from 0 to below 1/2");
  if (!(spec.noise >= 0) || !std::isfinite(spec.noise)) throw OptionError("noise is not a finite number >= 0");
}

}  // namespace

const std::vector<std::string>& sample_kinds() {
  static const std::vector<std::string> kinds{"sphere",    "ellipsoid",  "torus",   "genus2",   "genus5",
                                              "trefoil",   "bumpy",      "star",    "plane",    "cut-sphere",
                                              "cut-torus", "swiss-roll", "s-curve", "slit-pipe"};
  return kinds;
}

const std::vector<std::string>& mesh_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> all = sample_kinds();
    all.insert(all.end(), {"icosphere", "jittered-torus", "noisy-sphere"});
    return all;
  }();
  return kinds;
}

PointSample sample(const std::string& kind, const SampleSpec& spec) {
  check(kind, spec);
  Random random(spec.seed);
  const std::vector<OrientedPoint> points = spec.sampling == Sampling::uniform ? draw_uniform(kind, spec.points, random)
                                            : spec.sampling == Sampling::blue  ? draw_blue(kind, spec.points, random)
                                                                               : lattice(kind, spec, random);
  const double deviation = spec.noise * bounding_box_diagonal(points);
  PointSample sample;
  for (const auto& [position, normal] : points)
    sample.points.push_back(deviation > 0 ? position + deviation * random.normal() * normal : position);
  return sample;
}

SurfaceMesh mesh(const std::string& kind, std::size_t faces, std::uint64_t seed) {
  Random random(seed);
  if (kind == "icosphere") return icosphere(faces);
  if (kind == "noisy-sphere") return noisy_sphere(faces, random);
  if (const Radial* body = find_radial(kind)) return radial_mesh(*body, faces);
  if (kind == "jittered-torus") return patch_mesh(*find_patch("torus"), faces, &random);
  if (const Patch* patch = find_patch(kind)) return patch_mesh(*patch, faces);
  if (const Implicit* surface = find_implicit(kind)) return surface_net(*surface, faces);
  fail_unknown(kind, mesh_kinds());
}

}  // namespace geodrome::shapes
