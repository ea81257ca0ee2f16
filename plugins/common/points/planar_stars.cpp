// SPDX-License-Identifier: MIT
#include "plugins/common/points/planar_stars.hpp"

#include <algorithm>
#include <cmath>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/points/cell_radius.hpp"

namespace geodrome {
namespace {

/// Four points count as cocircular if their distances from the centre differ by less than this share: either way to
/// split them serves as well. The share is far above the jitter of a stored lattice, and holds of a few percent of the
/// triangles of a random sample.
constexpr double cocircular_tolerance = 0.03;

/// A circle with more points than this is no lattice that the tangent plane shows.
constexpr std::size_t most_tied = 12;

struct Star {
  std::vector<StarCorner> corners;
  CellRadius radius;
};

Star star_of(CellRadiusFinder& finder, Index site, const Vec3& normal) {
  Star star;
  star.radius = finder(site, normal);
  const std::vector<CellCorner>& corners = finder.cell().corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i].edge.site != no_index)
      star.corners.push_back({corners[i].edge.site, finder.cell().real(i), finder.position(corners[i])});
  return star;
}

/// Finds the points as near to a corner as its own three; none if these are all.
std::vector<Index> tied_points(const StarCorner& corner, const Vec3& site, const Neighbours& neighbours,
                               std::vector<Neighbour>& found) {
  neighbours.nearest(corner.centre, most_tied, found);
  const double limit = (1 + cocircular_tolerance) * distance(corner.centre, site);
  std::vector<Index> tied;
  for (const Neighbour& n : found)
    if (std::sqrt(n.squared_distance) <= limit) tied.push_back(n.index);
  if (tied.size() < 4) tied.clear();
  std::sort(tied.begin(), tied.end());
  return tied;
}

}  // namespace

PlanarStars::PlanarStars(const Neighbours& neighbours, std::span<const Vec3> normals, double reach, RunContext& context,
                         ProgressShare share)
    : first_(neighbours.size() + 1, 0), radius_(neighbours.size()), bounded_(neighbours.size()) {
  const std::vector<Index> order = spatial_order(neighbours.points());
  std::vector<std::vector<StarCorner>> stars(neighbours.size());
  const double middle = 0.5 * (share.from + share.to);
  parallel_for(stars.size(), context, {share.from, middle}, [&](std::size_t begin, std::size_t end) {
    CellRadiusFinder finder(neighbours, reach);
    for (std::size_t k = begin; k < end; ++k) {
      const Index i = order[k];
      Star star = star_of(finder, i, normals[i]);
      stars[i] = std::move(star.corners);
      radius_[i] = star.radius.phi;
      bounded_[i] = star.radius.bounded;
    }
  });
  for (std::size_t i = 0; i < stars.size(); ++i) first_[i + 1] = first_[i] + stars[i].size();
  corners_.reserve(first_.back());
  for (const auto& star : stars) corners_.insert(corners_.end(), star.begin(), star.end());
  find_ties(neighbours, order, context, {middle, share.to});
}

/// Finds ties only where stars disagree: they add nothing where stars agree.
void PlanarStars::find_ties(const Neighbours& neighbours, const std::vector<Index>& order, RunContext& context,
                            ProgressShare share) {
  ties_.resize(size());
  parallel_for(size(), context, share, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbour> found;
    for (std::size_t k = begin; k < end; ++k) {
      const Index s = order[k];
      const std::span<const StarCorner> star = (*this)(s);
      for (std::size_t i = 0; i < star.size(); ++i) {
        const Index a = star[i == 0 ? star.size() - 1 : i - 1].site, b = star[i].site;
        if (!star[i].real || (in_ring(a, s, b) && in_ring(b, s, a))) continue;
        std::vector<Index> tied = tied_points(star[i], neighbours.points()[s], neighbours, found);
        if (!tied.empty()) ties_[s].push_back(std::move(tied));
      }
    }
  });
}

bool PlanarStars::in_ring(Index point, Index a, Index b) const {
  const std::span<const StarCorner> star = (*this)(point);
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Index before = star[i == 0 ? star.size() - 1 : i - 1].site, here = star[i].site;
    if (star[i].real && ((before == a && here == b) || (before == b && here == a))) return true;
  }
  return false;
}

bool PlanarStars::in_tie(Index point, Index a, Index b) const {
  const auto holds = [](const std::vector<Index>& tied, Index p) {
    return std::binary_search(tied.begin(), tied.end(), p);
  };
  return std::ranges::any_of(ties_[point],
                             [&](const auto& tied) { return holds(tied, point) && holds(tied, a) && holds(tied, b); });
}

int PlanarStars::holders(const std::array<Index, 3>& triangle, bool* by_ties) const {
  int count = 0;
  bool tied = false;
  for (int i = 0; i < 3; ++i) {
    const Index p = triangle[i], a = triangle[(i + 1) % 3], b = triangle[(i + 2) % 3];
    const bool ring = in_ring(p, a, b), tie = !ring && in_tie(p, a, b);
    count += ring || tie;
    tied = tied || tie;
  }
  if (by_ties) *by_ties = tied;
  return count;
}

StarAgreement agreement(const PlanarStars& stars, std::span<const Vec3> points, std::span<const double> farthest) {
  StarAgreement result;
  // A triangle of k stars is met k times, each time with a share of the weight that makes it one.
  double all = 0, ties = 0, inconsistent = 0;
  for (Index s = 0; s < stars.size(); ++s) {
    const std::span<const StarCorner> star = stars(s);
    bool here = false;
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (!star[i].real || distance(star[i].centre, points[s]) > farthest[s]) continue;
      bool tied = false;
      const int holders = stars.holders({s, star[i == 0 ? star.size() - 1 : i - 1].site, star[i].site}, &tied);
      const double weight = 1.0 / holders;
      all += weight;
      if (tied) ties += weight;
      if (tied || holders == 3) continue;
      inconsistent += weight;
      here = true;
    }
    if (here) result.places.push_back(s);
  }
  if (all > 0) result.ties = ties / all;
  if (all > ties) result.inconsistent = inconsistent / (all - ties);
  return result;
}

}  // namespace geodrome
