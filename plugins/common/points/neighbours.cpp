// SPDX-License-Identifier: MIT
#include "plugins/common/points/neighbours.hpp"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

using Tree = flann::KDTreeSingleIndex<flann::L2_3D<double>>;

/// Raises a search limit so that it reaches every point that is not farther than `squared`: FLANN leaves out what is as
/// far as the limit, and sums up box distances with a rounding error of a few ulp a level of the tree.
constexpr double search_slack = 1e-12;
double raised(double squared) { return squared * (1 + search_slack) + std::numeric_limits<double>::min(); }

/// Distances that differ relatively by less are ties: far above rounding, far below what a sample can mean.
constexpr double tie_tolerance = 1e-9;

class NearestResult final : public flann::ResultSet<double> {
 public:
  NearestResult(std::size_t k, Index without, std::vector<Neighbour>& out) : k_(k), without_(without), out_(out) {}

  bool full() const override { return out_.size() == k_; }
  double worstDist() const override { return full() ? raised(out_.back().squared_distance) : infinity; }
  void addPoint(double squared_distance, std::size_t index) override {
    const Neighbour found{squared_distance, static_cast<Index>(index)};
    if (found.index == without_) return;
    if (full()) {
      if (found > out_.back()) return;
      out_.pop_back();
    }
    out_.insert(std::upper_bound(out_.begin(), out_.end(), found), found);
  }

 private:
  const std::size_t k_;
  const Index without_;
  std::vector<Neighbour>& out_;
};

class BallResult final : public flann::ResultSet<double> {
 public:
  BallResult(double radius, Index without, std::vector<Neighbour>& out)
      : radius_(radius), limit_(raised(radius * radius)), without_(without), out_(out) {}

  bool full() const override { return true; }
  double worstDist() const override { return limit_; }
  void addPoint(double squared_distance, std::size_t index) override {
    const Neighbour found{squared_distance, static_cast<Index>(index)};
    if (found.index != without_ && std::sqrt(squared_distance) <= radius_) out_.push_back(found);
  }

 private:
  const double radius_, limit_;
  const Index without_;
  std::vector<Neighbour>& out_;
};

void check(const std::vector<Vec3>& points) {
  if (points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw SampleError("the sample has more than 2^31 - 1 points", "thin it out");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) throw SampleError("point " + std::to_string(i) + " is not finite", "remove it");
}

}  // namespace

struct Neighbours::Impl {
  std::vector<Vec3> points;
  std::unique_ptr<Tree> tree;  // null if there are no points, for FLANN needs one

  explicit Impl(std::vector<Vec3> given) : points(std::move(given)) {
    check(points);
    if (points.empty()) return;
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    const flann::Matrix<double> rows(&points.front().x, points.size(), 3);
    tree = std::make_unique<Tree>(rows);
    tree->buildIndex();
  }

  void search(const Vec3& query, flann::ResultSet<double>& result) const {
    static const flann::SearchParams exact(flann::FLANN_CHECKS_UNLIMITED, 0.0F);
    if (tree) tree->findNeighbors(result, &query.x, exact);
  }
};

Neighbours::Neighbours(std::vector<Vec3> points) : impl_(std::make_unique<const Impl>(std::move(points))) {}
Neighbours::~Neighbours() = default;
Neighbours::Neighbours(Neighbours&&) noexcept = default;
Neighbours& Neighbours::operator=(Neighbours&&) noexcept = default;

std::size_t Neighbours::size() const noexcept { return impl_->points.size(); }
const std::vector<Vec3>& Neighbours::points() const noexcept { return impl_->points; }

void Neighbours::nearest(const Vec3& query, std::size_t k, std::vector<Neighbour>& out, Index without) const {
  out.clear();
  if (k == 0) return;
  NearestResult result(k, without, out);
  impl_->search(query, result);
}

void Neighbours::nearest_and_ties(const Vec3& query, std::size_t k, std::vector<Neighbour>& out, Index without) const {
  nearest(query, k + 1, out, without);
  if (k == 0 || out.size() <= k) return;
  const double radius = std::sqrt(out[k - 1].squared_distance) * (1 + tie_tolerance);
  if (std::sqrt(out[k].squared_distance) > radius)
    out.pop_back();
  else
    within(query, radius, out, without);
}

void Neighbours::within(const Vec3& query, double radius, std::vector<Neighbour>& out, Index without) const {
  out.clear();
  BallResult result(radius, without, out);
  impl_->search(query, result);
  std::sort(out.begin(), out.end());
}

}  // namespace geodrome
