// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geodrome/geometry.hpp"

/// Small point samples of known surfaces, seeded; nothing about them is special to one stage.
namespace geodrome::shapes::small {

/// Uniform numbers that are the same on every platform.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t n) { return engine_() % n; }
  Vec3 direction() {
    const double z = uniform(-1, 1), a = uniform(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(a), r * std::sin(a), z};
  }

 private:
  std::mt19937_64 engine_;
};

inline PointSample sphere(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) sample.points.push_back(random.direction());
  return sample;
}

/// Half-axes 3, 2, 1; denser at the poles of the long axis.
inline PointSample ellipsoid(std::size_t n, std::uint64_t seed) {
  PointSample sample = sphere(n, seed);
  for (Vec3& p : sample.points) p = {3 * p.x, 2 * p.y, p.z};
  return sample;
}

/// Radii 1 and 0.4. `skew` >= 1 moves the density to one side: 1 is uniform in area up to rejection, 10 about 1 : 100.
inline PointSample torus(std::size_t n, std::uint64_t seed, double skew = 1) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) {
    const double u = random.uniform(0, 2 * std::numbers::pi), v = random.uniform(0, 2 * std::numbers::pi);
    const double ring = 1 + 0.4 * std::cos(v);
    const double wanted = ring / 1.4 * std::pow(skew, -(1 - std::cos(u)));
    if (random.uniform() < wanted) sample.points.push_back({ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)});
  }
  return sample;
}

/// Unit spacing in the plane z = 0; row by row.
inline PointSample plane_lattice(std::size_t columns, std::size_t rows) {
  PointSample sample;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      sample.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  return sample;
}

/// Uniform in the unit square of the plane z = 0.
inline PointSample plane(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) sample.points.push_back({random.uniform(), random.uniform(), 0});
  return sample;
}

/// Uniform in the unit cube: no surface at all.
inline PointSample cube(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) sample.points.push_back({random.uniform(), random.uniform(), random.uniform()});
  return sample;
}

/// Each point moved by up to `size` in a random direction.
inline PointSample with_noise(PointSample sample, double size, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : sample.points) p = p + random.uniform(0, size) * random.direction();
  return sample;
}

/// Rotated by a fixed general rotation, scaled, then moved.
inline PointSample moved(PointSample sample, double scale, const Vec3& offset) {
  // Columns of the rotation by the unit quaternion (1, 2, 3, 4) / sqrt(30).
  const Vec3 x{-20 / 30.0, 20 / 30.0, 10 / 30.0}, y{4 / 30.0, -10 / 30.0, 28 / 30.0}, z{22 / 30.0, 20 / 30.0, 4 / 30.0};
  for (Vec3& p : sample.points) p = scale * (p.x * x + p.y * y + p.z * z) + offset;
  return sample;
}

/// `result[k]`: the index in the first sample of point k of the second.
inline std::vector<Index> permutation(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Index> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<Index>(i);
  for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

inline PointSample permuted(const PointSample& sample, const std::vector<Index>& order) {
  PointSample result;
  for (const Index i : order) result.points.push_back(sample.points[i]);
  return result;
}

}  // namespace geodrome::shapes::small
