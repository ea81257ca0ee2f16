// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/level_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "geodrome/errors.hpp"
#include "tools/shapes/implicit.hpp"
#include "tools/shapes/radial.hpp"

namespace geodrome::bench {
namespace {

using shapes::identity3;
using shapes::square;
using shapes::Symmetric3;
using shapes::symmetric_product;

LevelValue quadric(const Vec3& x, const Vec3& semi_axes) {
  const auto& [a, b, c] = semi_axes;
  const Symmetric3 form{1 / (a * a), 1 / (b * b), 1 / (c * c)};
  const Vec3 image = form * x;
  return {dot(x, image) - 1, 2 * image, 2 * form};
}

/// A curve at a parameter: where it is, and its derivatives.
struct CurvePoint {
  Vec3 at, first, second;
};

/// Distance to a curve, less the radius; `centre`: where the curve is closest to x.
LevelValue tube_around(const CurvePoint& centre, double radius, const Vec3& x) {
  const Vec3 out = x - centre.at;
  const double d = norm(out), bend = squared_norm(centre.first) - dot(out, centre.second);
  return {d - radius, out / d, 1 / d * (identity3 + (-1 / (d * d)) * square(out) + (-1 / bend) * square(centre.first))};
}

LevelValue torus(const Vec3& x) {
  const double from_axis = std::hypot(x.x, x.y), cosine = x.x / from_axis, sine = x.y / from_axis;
  const Vec3 at{cosine, sine, 0};
  return tube_around({at, {-sine, cosine, 0}, -at}, 0.4, x);
}

CurvePoint trefoil_curve(double t) {
  const double s1 = std::sin(t), c1 = std::cos(t), s2 = 2 * s1 * c1, c2 = c1 * c1 - s1 * s1;
  const double s3 = s1 * c2 + c1 * s2, c3 = c1 * c2 - s1 * s2;
  return {Vec3{s1 + 2 * s2, c1 - 2 * c2, -s3} / 3, Vec3{c1 + 4 * c2, -s1 + 4 * s2, -3 * c3} / 3,
          Vec3{-s1 - 8 * s2, -c1 + 8 * c2, 9 * s3} / 3};
}

/// Where the curve is closest to x among points 0.39 apart at most: a point of the tube is within 0.22 of one on its
/// own strand, and 0.3 from all others, for strands are 0.4 apart.
double nearest_parameter(const Vec3& x) {
  constexpr std::size_t count = 32;
  constexpr double step = 2 * std::numbers::pi / count;
  static const std::array<Vec3, count> places = [] {
    std::array<Vec3, count> made;
    for (std::size_t i = 0; i < count; ++i) made[i] = trefoil_curve(step * static_cast<double>(i)).at;
    return made;
  }();
  std::array<double, count> gaps;
  for (std::size_t i = 0; i < count; ++i) gaps[i] = squared_distance(places[i], x);
  return step * static_cast<double>(std::ranges::min_element(gaps) - gaps.begin());
}

LevelValue trefoil(const Vec3& x) {
  constexpr int most_steps = 20;
  constexpr double settled = 1e-9;  // Newton's next step would be of the order of its square
  double t = nearest_parameter(x);
  CurvePoint centre = trefoil_curve(t);
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 out = x - centre.at;
    const double step = dot(out, centre.first) / (squared_norm(centre.first) - dot(out, centre.second));
    centre = trefoil_curve(t += step);
    if (std::abs(step) < settled) break;
  }
  return tube_around(centre, 0.1, x);
}

/// |x| - R(x / |x|).
LevelValue radial(const shapes::Radial& body, const Vec3& x) {
  const double r = norm(x);
  const Vec3 d = x / r;
  const LevelValue radius = body.radius(d);
  const double outward = dot(radius.gradient, d);
  const Vec3 along = radius.gradient - outward * d, bent = radius.hessian * d;
  const Symmetric3 across = identity3 + -1 * square(d);
  const Symmetric3 seen = radius.hessian + -1 * symmetric_product(bent, d) + dot(bent, d) * square(d);
  const Symmetric3 second = seen + -outward * across + -1 * symmetric_product(along, d);
  return {r - radius.value, d - along / r, 1 / r * across + -1 / (r * r) * second};
}

const std::pair<std::string, LevelSet> level_sets[] = {
    {"sphere",
     [](const Vec3& x) {
       return quadric(x, {1, 1, 1});
     }},
    {"ellipsoid",
     [](const Vec3& x) {
       return quadric(x, {1, 0.8, 0.6});
     }},
    {"torus", torus},
    {"trefoil", trefoil},
    {"genus2", shapes::find_implicit("genus2")->at},
    {"genus5", shapes::find_implicit("genus5")->at},
    {"bumpy", [](const Vec3& x) { return radial(*shapes::find_radial("bumpy"), x); }},
    {"star", [](const Vec3& x) { return radial(*shapes::find_radial("star"), x); }},
};

}  // namespace

const std::vector<std::string>& smooth_shapes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& [name, level] : level_sets) all.push_back(name);
    return all;
  }();
  return names;
}

LevelSet level_set_of(const std::string& shape) {
  for (const auto& [name, level] : level_sets)
    if (name == shape) return level;
  std::string valid;
  for (const std::string& name : smooth_shapes()) valid += (valid.empty() ? "" : ", ") + name;
  throw OptionError("no true distances on '" + shape + "'", "valid shapes: " + valid);
}

std::optional<double> feature_size(const std::string& shape) {
  if (shape == "sphere") return 1;
  if (shape == "torus") return 0.4;
  if (shape == "trefoil") return 0.1;
  return {};
}

Vec3 on_level_set(LevelSet level, Vec3 point) {
  constexpr int most_steps = 50;
  constexpr double settled = 1e-15;  // the shapes have size 1
  for (int step = 0; step < most_steps; ++step) {
    const LevelValue f = level(point);
    const Vec3 move = (f.value / squared_norm(f.gradient)) * f.gradient;
    point = point - move;
    if (!(norm(move) > settled)) break;
  }
  return point;
}

}  // namespace geodrome::bench
