// SPDX-License-Identifier: MIT
#include "plugins/common/points/cell_radius.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geodrome/errors.hpp"
#include "plugins/common/points/frame.hpp"

namespace geodrome {
namespace {

constexpr std::size_t first_neighbours = 16;  // enough for most cells
constexpr std::size_t near_neighbours = 64;   // then the corners themselves are asked

}  // namespace

CellRadius CellRadiusFinder::operator()(Index site, const Vec3& normal) {
  origin_ = neighbours_.points()[site];
  u_ = tangent_to(normal);
  v_ = cross(normal, u_);
  cell_.reset(reach_);
  if (!cut_by_near(site)) cut_by_far(site);
  if (const auto vertex = cell_.farthest_real()) return {*vertex, cell_.bounded()};
  if (const auto edge = cell_.farthest_edge()) return {*edge, false};
  throw SampleError("point " + std::to_string(site) + " has no neighbour along its tangent plane",
                    "the sample needs more points around it");
}

/// Cuts the cell by the bisector of the site and `other`, in the plane: x.d <= |d|^2 / 2 with d = other - site. Returns
/// false if nothing was cut off.
bool CellRadiusFinder::cut(Index other) {
  const Vec3 d = neighbours_.points()[other] - origin_;
  const double x = dot(d, u_), y = dot(d, v_);
  const double length = std::hypot(x, y);
  if (length == 0) return false;  // straight above: the bisector does not meet the plane
  return cell_.cut({x / length, y / length, squared_norm(d) / (2 * length), other});
}

/// Cuts the cell by neighbours in increasing distance until the next one is farther than twice the farthest corner, and
/// so cuts nothing. Returns true if it came to that, or to the last point.
bool CellRadiusFinder::cut_by_near(Index site) {
  std::size_t done = 0;
  for (std::size_t k = first_neighbours; k <= near_neighbours; k *= 2) {
    neighbours_.nearest(origin_, k, found_, site);
    for (; done < found_.size(); ++done) {
      if (std::sqrt(found_[done].squared_distance) > 2 * cell_.farthest()) return true;
      cut(found_[done].index);
    }
    if (found_.size() < k) return true;
  }
  return false;
}

/// Cuts off every corner that has a point nearer to it than the site, by that point; a corner with none is final.
/// Asking the corners ends after a few questions also for cells without an end, where the other way would go through
/// the whole sample.
void CellRadiusFinder::cut_by_far(Index site) {
  tried_.assign(1, site);
  for (const CellCorner& c : cell_.corners()) tried_.push_back(c.edge.site);
  for (std::size_t i = 0; i < cell_.corners().size();) {
    const CellCorner& corner = cell_.corners()[i];
    neighbours_.nearest(position(corner), 1, found_);
    const Index other = found_.front().index;
    // This is the site itself, or one whose edge is there already: no nearer than the site but for rounding.
    const bool tried = std::find(tried_.begin(), tried_.end(), other) != tried_.end();
    if (!tried) tried_.push_back(other);
    // A cut renumbers the corners. Asking all of them again costs little: there are some six.
    i = !tried && cut(other) ? 0 : i + 1;
  }
}

double sample_reach(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + (p - points.front());
  const Vec3 centroid = points.front() + sum / static_cast<double>(points.size());
  double farthest = 0;
  for (const Vec3& p : points) farthest = std::max(farthest, squared_distance(p, centroid));
  return 2 * std::sqrt(farthest);
}

}  // namespace geodrome
