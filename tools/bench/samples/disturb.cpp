// SPDX-License-Identifier: MIT
#include "tools/bench/samples/disturb.hpp"

#include <algorithm>
#include <cmath>

#include "tools/shapes/random.hpp"

namespace geodrome::bench {

PointSample with_outliers(PointSample sample, double share, std::uint64_t seed) {
  constexpr double enlarged = 1.1;
  Vec3 low = sample.points.front(), high = low;
  for (const Vec3& p : sample.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 centre = 0.5 * (low + high), half = 0.5 * enlarged * (high - low);
  shapes::Random random(seed);
  for (auto left = std::llround(share * static_cast<double>(sample.size())); left > 0; --left) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    sample.points.push_back(centre + Vec3{x * half.x, y * half.y, z * half.z});
  }
  return sample;
}

PointSample jittered(PointSample sample, double size, std::uint64_t seed) {
  shapes::Random random(seed);
  for (Vec3& p : sample.points) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size), z = random.uniform(-size, size);
    p = p + Vec3{x, y, z};
  }
  return sample;
}

}  // namespace geodrome::bench
