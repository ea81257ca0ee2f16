// SPDX-License-Identifier: MIT
#include "plugins/common/planar_stars.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/common/cell_radius.hpp"
#include "plugins/common/spatial_order.hpp"

namespace geodrome {
namespace {

/// Four points count as cocircular if their distances from the centre differ by less than this share: either way to
/// split them serves as well. Far above the jitter of a stored lattice; a few percent of the triangles of a random
/// sample.
constexpr double tie_tolerance = 0.03;

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

bool is_tie(const StarCorner& corner, const Vec3& site, const Neighbours& neighbours, std::vector<Neighbour>& found) {
  neighbours.nearest(corner.centre, 4, found);
  return found.size() == 4 &&
         std::sqrt(found[3].squared_distance) <= (1 + tie_tolerance) * distance(corner.centre, site);
}

}  // namespace

PlanarStars::PlanarStars(const Neighbours& neighbours, std::span<const Vec3> normals, double reach, RunContext& context,
                         ProgressShare share)
    : first_(neighbours.size() + 1, 0), radius_(neighbours.size()), bounded_(neighbours.size()) {
  const std::vector<Index> order = spatial_order(neighbours.points());
  std::vector<std::vector<StarCorner>> stars(neighbours.size());
  parallel_for(stars.size(), context, share, [&](std::size_t begin, std::size_t end) {
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
}

bool PlanarStars::has(Index point, Index a, Index b) const {
  const std::span<const StarCorner> star = (*this)(point);
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Index before = star[i == 0 ? star.size() - 1 : i - 1].site, here = star[i].site;
    if (star[i].real && ((before == a && here == b) || (before == b && here == a))) return true;
  }
  return false;
}

StarAgreement agreement(const PlanarStars& stars, const Neighbours& neighbours, std::span<const double> farthest) {
  StarAgreement result;
  // A triangle of k stars is met k times, each time with a third of the weight that makes it one.
  std::vector<Neighbour> found;
  double all = 0, ties = 0, inconsistent = 0;
  for (Index s = 0; s < stars.size(); ++s) {
    const std::span<const StarCorner> star = stars(s);
    bool here = false;
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (!star[i].real || distance(star[i].centre, neighbours.points()[s]) > farthest[s]) continue;
      const Index a = star[i == 0 ? star.size() - 1 : i - 1].site, b = star[i].site;
      const int holders = 1 + stars.has(a, s, b) + stars.has(b, s, a);
      const double weight = 1.0 / holders;
      all += weight;
      if (holders == 3) continue;
      const bool tie = is_tie(star[i], neighbours.points()[s], neighbours, found);
      (tie ? ties : inconsistent) += weight;
      here = here || !tie;
    }
    if (here) result.places.push_back(s);
  }
  if (all > 0) result.ties = ties / all;
  if (all > ties) result.inconsistent = inconsistent / (all - ties);
  return result;
}

}  // namespace geodrome
