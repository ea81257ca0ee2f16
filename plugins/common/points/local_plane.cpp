// SPDX-License-Identifier: MIT
#include "plugins/common/points/local_plane.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

/// A neighbourhood whose variance across is below this share of its variance along may be a row of a scan: it grows.
constexpr double thin_ratio = 0.1;
/// A thin neighbourhood of so many neighbours is taken as it is.
constexpr std::size_t enough_neighbours = 400;
/// Points are on a line if their variance across is below this share of that along. Eigenvalues are known to some 1e-15
/// of the largest, so a normal found above this ratio is off by a milliradian at most.
constexpr double collinear_ratio = 1e-12;

}  // namespace

bool LocalPlane::collinear() const { return !(ratio > collinear_ratio); }

LocalPlane plane_of(const std::vector<Vec3>& points, const Vec3& base, const std::vector<Neighbour>& around) {
  const double count = static_cast<double>(around.size() + 1);
  // Sums of differences from the point: a sample far from the origin loses nothing.
  Vec3 sum;
  for (const Neighbour& n : around) sum = sum + (points[n.index] - base);
  const Vec3 mean = sum / count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const auto add = [&](const Vec3& offset) {
    const Eigen::Vector3d d(offset.x, offset.y, offset.z);
    covariance += d * d.transpose();
  };
  add(-mean);
  for (const Neighbour& n : around) add(points[n.index] - base - mean);

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d e = solver.eigenvectors().col(0);
  const Vec3 normal = Vec3{e.x(), e.y(), e.z()} / e.norm();
  double squares = 0;
  for (const Neighbour& n : around) {
    const double height = dot(normal, points[n.index] - base - mean);
    squares += height * height;
  }
  squares += dot(normal, mean) * dot(normal, mean);
  const double along = solver.eigenvalues()[2];
  return {normal, std::sqrt(squares / count), along > 0 ? solver.eigenvalues()[1] / along : 0, around.size()};
}

LocalPlane grown_plane(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  for (;; k = std::max(k + 1, k < enough_neighbours ? std::min(2 * k, enough_neighbours) : 2 * k)) {
    neighbours.nearest_and_ties(points[at], k, around, at);
    LocalPlane plane = plane_of(points, points[at], around);
    plane.k = k;
    const bool all = around.size() + 1 >= points.size();
    if (all || plane.ratio >= thin_ratio || (!plane.collinear() && k >= enough_neighbours)) return plane;
  }
}

void throw_collinear(Index at, std::size_t sample_size) {
  throw SampleError("point " + std::to_string(at) + " has no tangent plane: all " + std::to_string(sample_size) +
                        " points of the sample are on one line",
                    "a surface needs points that are not on a line");
}

void require_three_points(std::size_t sample_size) {
  if (sample_size < 3)
    throw SampleError("point 0 has no tangent plane: the sample has " + std::to_string(sample_size) + " points",
                      "a plane needs at least three");
}

}  // namespace geodrome
