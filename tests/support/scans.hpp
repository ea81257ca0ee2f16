// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "tests/support/samples.hpp"

/// Samples as scanners make them, seeded, of surfaces whose distances are known.
namespace geodrome::test {

/// Adds points that are uniform in the cube from -half to half.
inline void add_outliers(PointSample& sample, std::size_t count, double half, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < count; ++i)
    sample.points.push_back({random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half)});
}

/// The square from -0.5 to 0.5 in the plane z = 0, uniform, without the disc of this radius around 0.
inline PointSample plane_with_hole(std::size_t n, double radius, std::uint64_t seed) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) {
    const Vec3 p{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0};
    if (norm(p) > radius) sample.points.push_back(p);
  }
  return sample;
}

/// The unit square, `factor` times as dense at x = 1 as at x = 0.
inline PointSample graded_plane(std::size_t n, double factor, std::uint64_t seed) {
  Random random(seed);
  PointSample sample;
  while (sample.size() < n) {
    const Vec3 p{random.uniform(), random.uniform(), 0};
    if (random.uniform() < std::pow(factor, p.x - 1)) sample.points.push_back(p);
  }
  return sample;
}

/// A plane seen twice: two layers that are 0.3 spacings apart, each with noise of a tenth of the spacing.
inline PointSample doubled_plane(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  const double spacing = 1 / std::sqrt(static_cast<double>(n));
  const auto noise = [&] { return 0.1 * spacing * (random.uniform() + random.uniform() + random.uniform() - 1.5) * 2; };
  PointSample sample;
  for (std::size_t i = 0; i < n; ++i)
    sample.points.push_back({random.uniform(), random.uniform(), (i % 2 == 0 ? 0.3 * spacing : 0) + noise()});
  return sample;
}

/// A depth image: a grid of rays that meet a near plane or, where a box stands in front of nothing, a far one, with
/// flying pixels along the jump.
struct DepthImage {
  enum Kind { near_plane, far_plane, flying };
  std::vector<Vec3> points;
  std::vector<Kind> kind;
};

/// `size` x `size` rays; the near plane fills the left 0.6 of the image. Depths have noise of a tenth of the spacing.
inline DepthImage depth_image(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  DepthImage image;
  const auto last = static_cast<double>(size - 1);
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column) {
      const double x = static_cast<double>(column) / last - 0.5, y = static_cast<double>(row) / last - 0.5;
      const bool jump = std::abs(x - 0.1) < 1.5 / last, near = x < 0.1;
      const double depth = jump ? random.uniform(1, 2) : (near ? 1 : 2) + random.uniform(-0.1, 0.1) / last;
      image.points.push_back({x * depth, y * depth, depth});
      image.kind.push_back(jump ? DepthImage::flying : near ? DepthImage::near_plane : DepthImage::far_plane);
    }
  return image;
}

}  // namespace geodrome::test
