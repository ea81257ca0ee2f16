// SPDX-License-Identifier: MIT
#include "tools/bench/shapes/broken_geodesic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geodrome/errors.hpp"

namespace geodrome::bench {
namespace {

/// A broken geodesic: arc i runs from node i to node i + 1.
struct Broken {
  std::vector<Vec3> nodes;
  std::vector<GeodesicArc> arcs;
  double length = 0;

  Broken(LevelSet level, std::vector<Vec3> through) : nodes(std::move(through)) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      arcs.push_back(connect(level, nodes[i], nodes[i + 1]));
      length += arcs.back().length;
    }
  }
};

/// How the length changes when inner node i + 1 moves by y_i along across_i: g.y + y.H y / 2, H tridiagonal.
struct Quadratic {
  std::vector<Vec3> across;
  std::vector<double> slope, diagonal, beside;

  Quadratic(LevelSet level, const Broken& path) {
    for (std::size_t i = 1; i < path.arcs.size(); ++i) {
      const GeodesicArc &in = path.arcs[i - 1], &out = path.arcs[i];
      const Vec3 side = cross(normal_at(level, path.nodes[i]), in.arriving + out.leaving);
      across.push_back(side / norm(side));
      slope.push_back(dot(in.arriving - out.leaving, across.back()));
      diagonal.push_back(in.turned.slope / in.turned.value + out.moved.value / out.turned.value);
      beside.push_back(-1 / out.turned.value);
    }
  }

  /// The minimum of the quadratic with `lift` added to the diagonal, by Cholesky's method; none if there is none.
  std::optional<std::vector<double>> minimum(double lift) const {
    const std::size_t n = slope.size();
    std::vector<double> pivot(n), y(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double factor = i > 0 ? beside[i - 1] / pivot[i - 1] : 0;
      pivot[i] = diagonal[i] + lift - (i > 0 ? factor * beside[i - 1] : 0);
      y[i] = -slope[i] - (i > 0 ? factor * y[i - 1] : 0);
      if (!(pivot[i] > 0)) return {};
    }
    for (std::size_t i = n; i-- > 0;) y[i] = (y[i] - (i + 1 < n ? beside[i] * y[i + 1] : 0)) / pivot[i];
    return y;
  }

  /// Where to go: to the minimum, or downhill where the quadratic has none. A lift of the sum of the largest entries of
  /// a row is enough.
  std::vector<double> step() const {
    if (auto y = minimum(0)) return *std::move(y);
    double scale = 0;
    for (const double entry : diagonal) scale = std::max(scale, std::abs(entry));
    for (const double entry : beside) scale = std::max(scale, std::abs(entry));
    for (const double share : {1e-3, 4e-3, 0.016, 0.064, 0.25, 1.0, 4.0})
      if (auto y = minimum(share * scale)) return *std::move(y);
    throw NumericalError("the second derivative of a path's length is not finite");
  }
};

double gain(const Quadratic& model, const std::vector<double>& y) {
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) sum -= 0.5 * model.slope[i] * y[i];
  return sum;
}

/// The share of a step that moves no node farther than half a piece: what is farther is another path.
double first_share(const Broken& path, const std::vector<double>& y) {
  const double limit = 0.5 * path.length / static_cast<double>(path.arcs.size());
  double largest = 0;
  for (const double move : y) largest = std::max(largest, std::abs(move));
  return largest > limit ? limit / largest : 1;
}

/// The path with its inner nodes moved; none if pieces are no longer found or it is not shorter.
std::optional<Broken> moved(LevelSet level, const Broken& path, const Quadratic& model, const std::vector<double>& y,
                            double share) {
  std::vector<Vec3> nodes = path.nodes;
  for (std::size_t i = 0; i < y.size(); ++i)
    nodes[i + 1] = on_level_set(level, nodes[i + 1] + share * y[i] * model.across[i]);
  try {
    Broken next(level, std::move(nodes));
    if (next.length < path.length) return next;
  } catch (const NumericalError&) {
  }
  return {};
}

std::vector<Vec3> first_nodes(LevelSet level, std::span<const Vec3> polyline, double turn) {
  double bend = 0;
  for (const Vec3& p : polyline) bend = std::max(bend, curvature_bound(level, p));
  const double pieces = std::max(1.0, std::ceil(length_of(polyline) * bend / turn));
  std::vector<Vec3> nodes = resampled(polyline, static_cast<std::size_t>(pieces));
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) nodes[i] = on_level_set(level, nodes[i]);
  return nodes;
}

}  // namespace

double curvature_bound(LevelSet level, const Vec3& point) {
  const LevelValue f = level(point);
  const shapes::Symmetric3& h = f.hessian;
  const double squares = h.xx * h.xx + h.yy * h.yy + h.zz * h.zz + 2 * (h.xy * h.xy + h.xz * h.xz + h.yz * h.yz);
  return std::sqrt(squares) / norm(f.gradient);
}

double length_of(std::span<const Vec3> polyline) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) sum += distance(polyline[i], polyline[i + 1]);
  return sum;
}

std::vector<Vec3> resampled(std::span<const Vec3> polyline, std::size_t count) {
  const double step = length_of(polyline) / static_cast<double>(count);
  std::vector<Vec3> points{polyline.front()};
  double passed = 0;
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const double piece = distance(polyline[i], polyline[i + 1]);
    while (points.size() < count && step * static_cast<double>(points.size()) < passed + piece) {
      const double share = (step * static_cast<double>(points.size()) - passed) / piece;
      points.push_back(polyline[i] + share * (polyline[i + 1] - polyline[i]));
    }
    passed += piece;
  }
  points.resize(count, polyline.back());  // rounding may have kept the last inner ones out
  points.push_back(polyline.back());
  return points;
}

GeodesicPath shortened(LevelSet level, std::span<const Vec3> polyline, double turn) {
  constexpr int most_steps = 100, most_halvings = 12;
  constexpr double settled = 1e-15;  // of the length: a tenth of what rounding does to it
  constexpr double stuck = 1e-13;    // where rounding may hide that a step makes it shorter
  Broken path(level, first_nodes(level, polyline, turn));
  for (int step = 0; step < most_steps; ++step) {
    const Quadratic model(level, path);
    const std::vector<double> y = model.step();
    const double slack = gain(model, y);
    if (slack <= settled * path.length) return {path.length, path.nodes, slack};
    std::optional<Broken> next;
    double share = first_share(path, y);
    for (int i = 0; i < most_halvings && !next; ++i, share /= 2) next = moved(level, path, model, y, share);
    if (!next && slack <= stuck * path.length) return {path.length, path.nodes, slack};
    if (!next) break;
    path = *std::move(next);
  }
  throw NumericalError("a path did not settle as a geodesic");
}

}  // namespace geodrome::bench
