// SPDX-License-Identifier: MIT
#include "plugins/tangent_pca/pca_tangents.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <string>

#include "plugins/common/neighbours.hpp"
#include "plugins/common/parallel_for.hpp"
#include "plugins/common/spatial_order.hpp"

namespace geodrome {
namespace {

/// A neighbourhood whose variance across is below this share of its variance along may be a row of a scan: it grows.
constexpr double thin_ratio = 0.1;
/// Beyond so many neighbours a thin neighbourhood is taken as it is.
constexpr std::size_t enough_neighbours = 400;
/// Variance across, relative to along, below which points are on a line. Eigenvalues are known to some 1e-15 of the
/// largest, so a normal found above this ratio is off by a milliradian at most.
constexpr double collinear_ratio = 1e-12;

struct Fit {
  Vec3 normal;
  double residual = 0;
  double ratio = 0;  ///< variance across over variance along
};

Fit fit_plane(const std::vector<Vec3>& points, Index at, const std::vector<Neighbour>& around) {
  const double count = static_cast<double>(around.size() + 1);
  // Sums of differences from the point: a sample far from the origin loses nothing.
  Vec3 sum;
  for (const Neighbour& n : around) sum = sum + (points[n.index] - points[at]);
  const Vec3 mean = sum / count;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  const auto add = [&](const Vec3& offset) {
    const Eigen::Vector3d d(offset.x, offset.y, offset.z);
    covariance += d * d.transpose();
  };
  add(-mean);
  for (const Neighbour& n : around) add(points[n.index] - points[at] - mean);

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d e = solver.eigenvectors().col(0);
  const Vec3 normal = Vec3{e.x(), e.y(), e.z()} / e.norm();
  double squares = 0;
  for (const Neighbour& n : around) {
    const double height = dot(normal, points[n.index] - points[at] - mean);
    squares += height * height;
  }
  squares += dot(normal, mean) * dot(normal, mean);
  const double along = solver.eigenvalues()[2];
  return {normal, std::sqrt(squares / count), along > 0 ? solver.eigenvalues()[1] / along : 0};
}

TangentPlane plane_at(const Neighbours& neighbours, Index at, std::size_t k, std::vector<Neighbour>& around) {
  const std::vector<Vec3>& points = neighbours.points();
  for (;; k = std::max(k + 1, k < enough_neighbours ? std::min(2 * k, enough_neighbours) : 2 * k)) {
    neighbours.nearest_and_ties(points[at], k, around, at);
    const Fit fit = fit_plane(points, at, around);
    const bool all = around.size() + 1 >= points.size();
    if (fit.ratio >= thin_ratio || (fit.ratio > collinear_ratio && (all || k >= enough_neighbours)))
      return {points[at], fit.normal, fit.residual};
    if (all)
      throw SampleError("point " + std::to_string(at) + " has no tangent plane: all " + std::to_string(points.size()) +
                            " points of the sample are on one line",
                        "a surface needs points that are not on a line");
  }
}

}  // namespace

Tangents PcaTangents::estimate(const PointSample& sample, RunContext& context) const {
  if (sample.size() < 3)
    throw SampleError("point 0 has no tangent plane: the sample has " + std::to_string(sample.size()) + " points",
                      "a plane needs at least three");
  const Neighbours neighbours(sample.points);
  const std::vector<Index> order = spatial_order(sample.points);
  Tangents tangents;
  tangents.plane.resize(sample.size());
  tangents.state.assign(sample.size(), PointState::ok);
  parallel_for(sample.size(), context, {}, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> around;
    for (std::size_t i = begin; i < end; ++i) tangents.plane[order[i]] = plane_at(neighbours, order[i], k_, around);
  });
  return tangents;
}

}  // namespace geodrome
