// SPDX-License-Identifier: MIT
#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost.Geometry 1.74 includes a deprecated header of Boost's own
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>

#include "engine/checks/gauge.hpp"

namespace geodrome {

namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Point = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<Point, Index>;

/// As many as a vertex of a triangulation has on average.
constexpr unsigned neighbours = 6;

Point point(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

Claim claim_curvature(const PlacedSurface& surface) {
  const SampleStages& stages = *surface.sample;
  const std::vector<Vec3>& points = stages.smoothed.points;
  const std::vector<TangentPlane>& planes = stages.tangents.plane;
  Gauge gauge("phi_to_curvature_radius", "phi over radius of curvature <= 0.3", "practice", Claim::Sense::at_most,
              good_epsilon, stages.control.phi.size());
  std::vector<Entry> entries;
  for (const Index i : stages.kept) entries.emplace_back(point(points[i]), i);
  const bgi::rtree<Entry, bgi::linear<16>> tree(entries);
  std::vector<Entry> near;
  for (const Index i : stages.kept) {
    near.clear();
    tree.query(bgi::nearest(point(points[i]), neighbours + 1), std::back_inserter(near));
    for (const auto& [place, j] : near) {
      if (i == j) continue;
      const double cosine = std::min(1.0, std::abs(dot(planes[i].normal, planes[j].normal)));
      const double curvature = std::sqrt(2 * (1 - cosine)) / distance(points[i], points[j]);
      for (const Index end : {i, j}) gauge.add(end, stages.control.phi[end] * curvature);
    }
  }
  return std::move(gauge).finish("no points were kept");
}

}  // namespace geodrome
