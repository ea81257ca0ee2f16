// SPDX-License-Identifier: MIT
#include "engine/surface/sample_part.hpp"

#include <algorithm>
#include <cmath>

#include "engine/surface/nearest_points.hpp"

namespace geodrome {

namespace {

// Measured on scans (airborne LiDAR, a depth camera), on shapes with 5 to 17 % outliers in their bounding box, and on
// points that fill a cube, of which the same bounds leave connected groups of 25 in 20,000 at most.
constexpr std::size_t scales[] = {24, 96};
constexpr double flatness[] = {0.15, 0.1};
constexpr std::size_t near_count = 12;
constexpr double least_cosine = 0.9063;  ///< of 25 degrees
constexpr double steepness = 0.25;
constexpr double agreeing = 0.7;
/// An outlier beside a surface: so many times as high over the mean plane as its neighbours are, and by more than
/// rounding, or a curved surface's own height, makes.
constexpr double height_factor = 3;
constexpr double least_height = 0.02;  ///< of the radius
constexpr double density_factor = 2;   ///< between neighbours; gradual changes stay far below it

/// The points that stage 1 did not drop, with their normals.
struct Planes {
  std::vector<Vec3> points, normals;
  std::vector<Index> sample;  ///< which points of the sample they are
};

Planes planes_of(const SampleStages& stages) {
  Planes planes;
  for (Index i = 0; i < stages.tangents.state.size(); ++i) {
    if (stages.tangents.state[i] == PointState::dropped) continue;
    planes.points.push_back(stages.smoothed.points[i]);
    planes.normals.push_back(stages.tangents.plane[i].normal);
    planes.sample.push_back(i);
  }
  return planes;
}

/// The `k` nearest of every point, nearest first.
class Neighbourhoods {
 public:
  Neighbourhoods(const std::vector<Vec3>& points, std::size_t k, Observer& observer) : k_(k) {
    constexpr Index often = 4096;
    const NearestPoints tree(points);
    around_.reserve(k * points.size());
    for (Index i = 0; i < points.size(); ++i) {
      if (i % often == 0 && observer.cancelled()) throw Cancelled();
      std::vector<Index> found = tree.nearest(points[i], k + 1);
      std::erase(found, i);
      around_.insert(around_.end(), found.begin(), found.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  std::span<const Index> of(Index i, std::size_t count) const { return {around_.data() + i * k_, count}; }

 private:
  const std::size_t k_;
  std::vector<Index> around_;
};

/// The sample as seen from every point's `k` nearest.
class Scale {
 public:
  Scale(const Planes& planes, const Neighbourhoods& around, std::size_t k)
      : planes_(planes),
        around_(around),
        k_(k),
        normals_(planes.normals),
        centres_(planes.points.size()),
        radius_(centres_.size()) {
    average_normals(), average_normals();  // once leaves a normal that was far off its neighbours' out of line
    for (Index i = 0; i < centres_.size(); ++i) measure(i);
  }

  /// The largest connected part, as points of the sample, ascending.
  std::vector<Index> largest_part(double bound) const {
    std::vector<bool> fits(centres_.size());
    for (Index i = 0; i < fits.size(); ++i)
      fits[i] = flat(i, bound) && !stands_out(i) && agreement(i, bound) >= agreeing * near_count;
    detail::DisjointSets parts(fits.size());
    for (Index i = 0; i < fits.size(); ++i)
      for (std::size_t j = 0; j < near_count && fits[i]; ++j)
        if (const Index other = neighbours(i)[j]; fits[other] && joined(i, other)) parts.unite(i, other);
    std::vector<std::size_t> size(fits.size(), 0);
    for (Index i = 0; i < fits.size(); ++i)
      if (fits[i]) ++size[parts.find(i)];
    const auto largest = static_cast<Index>(std::ranges::max_element(size) - size.begin());
    std::vector<Index> part;
    for (Index i = 0; i < fits.size(); ++i)
      if (fits[i] && parts.find(i) == largest) part.push_back(planes_.sample[i]);
    return part;
  }

 private:
  std::span<const Index> neighbours(Index i) const { return around_.of(i, k_); }

  void average_normals() {
    std::vector<Vec3> mean(normals_.size());
    for (Index i = 0; i < mean.size(); ++i) {
      mean[i] = normals_[i];
      for (const Index j : neighbours(i))
        mean[i] = mean[i] + (dot(normals_[i], normals_[j]) < 0 ? -normals_[j] : normals_[j]);
      mean[i] = mean[i] / norm(mean[i]);
    }
    normals_ = std::move(mean);
  }

  void measure(Index i) {
    const Vec3& base = planes_.points[i];
    radius_[i] = distance(base, planes_.points[neighbours(i).back()]);
    Vec3 sum;
    for (const Index j : neighbours(i)) sum = sum + (planes_.points[j] - base);
    const Vec3 mean = sum / static_cast<double>(k_ + 1);
    centres_[i] = base + mean;
    double squares = 0;
    for (const Index j : neighbours(i)) squares += std::pow(dot(normals_[i], planes_.points[j] - base - mean), 2);
    height_.push_back(std::sqrt(squares / static_cast<double>(k_)));
  }

  bool stands_out(Index i) const {
    const double height = std::abs(dot(normals_[i], planes_.points[i] - centres_[i]));
    return height > std::max(height_factor * height_[i], least_height * radius_[i]);
  }

  bool flat(Index i, double bound) const { return height_[i] <= bound * radius_[i]; }

  bool agree(Index i, Index j) const {
    const Vec3 way = centres_[j] - centres_[i];
    const double most = steepness * distance(planes_.points[i], planes_.points[j]);
    return std::abs(dot(normals_[i], normals_[j])) >= least_cosine && std::abs(dot(way, normals_[i])) <= most &&
           std::abs(dot(way, normals_[j])) <= most;
  }

  bool joined(Index i, Index j) const {
    const auto [least, most] = std::minmax(radius_[i], radius_[j]);
    return agree(i, j) && most < density_factor * least;
  }

  double agreement(Index i, double bound) const {
    double count = 0;
    for (std::size_t j = 0; j < near_count; ++j) {
      const Index other = neighbours(i)[j];
      if (flat(other, bound) && agree(i, other)) ++count;
    }
    return count;
  }

  const Planes& planes_;
  const Neighbourhoods& around_;
  const std::size_t k_;
  std::vector<Vec3> normals_, centres_;
  std::vector<double> radius_, height_;
};

}  // namespace

std::vector<std::vector<Index>> part_candidates(const SampleStages& stages, Observer& observer) {
  const Planes planes = planes_of(stages);
  const std::size_t count = planes.points.size();
  std::vector<std::vector<Index>> parts;
  if (!enough_for_part(count, stages.tangents.state.size())) return parts;
  const Neighbourhoods around(planes.points, std::min(scales[1], count - 1), observer);
  for (const std::size_t k : scales) {
    if (count <= k) continue;
    const Scale scale(planes, around, k);
    for (const double bound : flatness) {
      std::vector<Index> part = scale.largest_part(bound);
      if (enough_for_part(part.size(), stages.tangents.state.size()) && std::ranges::find(parts, part) == parts.end())
        parts.push_back(std::move(part));
    }
  }
  std::ranges::stable_sort(parts, std::ranges::greater(), [](const auto& part) { return part.size(); });
  return parts;
}

}  // namespace geodrome
