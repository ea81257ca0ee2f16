// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/gaps.hpp"

#include <algorithm>
#include <limits>

#include "plugins/common_gpl/planar_triangles.hpp"

namespace geodrome {
namespace {

/// A gap counts as a hole from here on: randomly thin places of a uniform sample stay below 4 psi.
constexpr double hole_radius = 5;
/// Holes with fewer points around them cannot be told from thin places: a hole of five edges across has some twenty.
constexpr std::size_t hole_points = 20;

/// Circumradius over the smallest psi at the corners.
double relative_radius(const Triangle& face, const OrientedPiece& piece) {
  const Vec3 &a = piece.points[face[0]], &b = piece.points[face[1]], &c = piece.points[face[2]];
  const double twice_area = norm(cross(b - a, c - a));
  const double psi = std::min({piece.psi[face[0]], piece.psi[face[1]], piece.psi[face[2]]});
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * twice_area * psi);
}

bool is_hole(const Gap& gap, const std::vector<Triangle>& faces, const OrientedPiece& piece, const PlanarStars& stars) {
  if (gap.places.size() < hole_points) return false;
  double largest = 0;
  for (const Index f : gap.faces) largest = std::max(largest, relative_radius(faces[f], piece));
  if (!(largest > hole_radius)) return false;
  std::size_t open = 0;
  for (const Index p : gap.places) {
    const Index k = piece.kept[p];
    open += !stars.bounded(k) || stars.radius(k) > FaceRule::radius_bound * piece.psi[p];
  }
  return 2 * open > gap.places.size();
}

/// By its Euler number; `group[f]` tells the faces of one gap from others.
bool is_disk(const Gap& gap, const detail::Connectivity& connectivity, const std::vector<Index>& group) {
  std::size_t half_edges_inside = 0;
  for (const Index f : gap.faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index twin = connectivity.twins[h];
      half_edges_inside += twin != no_index && group[twin / 3] == group[f];
    }
  const std::size_t edges = 3 * gap.faces.size() - half_edges_inside / 2;
  return gap.places.size() + gap.faces.size() == edges + 1;
}

}  // namespace

std::vector<Gap> find_gaps(const std::vector<Triangle>& faces, const OrientedPiece& piece, const PlanarStars& stars) {
  const FaceRule rule{piece.points, piece.psi, true};
  std::vector<char> large(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) large[f] = !rule.allows(faces[f][0], faces[f][1], faces[f][2]);
  const detail::Connectivity connectivity = detail::connect(faces, piece.points.size());
  detail::DisjointSets groups(faces.size());
  for (Index h = 0; h < connectivity.twins.size(); ++h) {
    const Index twin = connectivity.twins[h];
    if (twin != no_index && large[h / 3] && large[twin / 3]) groups.unite(h / 3, twin / 3);
  }
  std::vector<Gap> gaps;
  std::vector<Index> gap_of_group(faces.size(), no_index), gap_of(faces.size(), no_index);
  for (Index f = 0; f < faces.size(); ++f) {
    if (!large[f]) continue;
    Index& gap = gap_of_group[groups.find(f)];
    if (gap == no_index) gap = static_cast<Index>(gaps.size()), gaps.emplace_back();
    gap_of[f] = gap;
    gaps[gap].faces.push_back(f);
    gaps[gap].places.insert(gaps[gap].places.end(), faces[f].begin(), faces[f].end());
  }
  for (Gap& gap : gaps) {
    std::sort(gap.places.begin(), gap.places.end());
    gap.places.erase(std::unique(gap.places.begin(), gap.places.end()), gap.places.end());
    gap.hole = is_hole(gap, faces, piece, stars);
    gap.disk = is_disk(gap, connectivity, gap_of);
  }
  return gaps;
}

}  // namespace geodrome
