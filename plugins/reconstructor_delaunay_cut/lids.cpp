// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/lids.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "plugins/common/manifold_faces.hpp"
#include "plugins/common_gpl/planar_triangles.hpp"

namespace geodrome {

Lids find_lids(const std::vector<Triangle>& faces, const OrientedPiece& piece, const PlanarStars& stars,
               BoundaryRule rule) {
  const FaceRule allowed{piece.points, piece.psi, true};
  std::vector<char> large(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) large[f] = !allowed.allows(faces[f][0], faces[f][1], faces[f][2]);
  const detail::Connectivity connectivity = detail::connect(faces, piece.points.size());
  detail::DisjointSets groups(faces.size());
  for (Index h = 0; h < connectivity.twins.size(); ++h) {
    const Index t = connectivity.twins[h];
    if (t != no_index && large[h / 3] && large[t / 3]) groups.unite(h / 3, t / 3);
  }
  std::vector<std::vector<Index>> members(faces.size());
  for (Index f = 0; f < faces.size(); ++f)
    if (large[f]) members[groups.find(f)].push_back(f);
  Lids lids;
  for (const auto& group : members) {
    if (group.empty()) continue;
    double worst = 0;
    std::set<Index> vertices;
    for (const Index f : group) {
      const auto& [a, b, c] = faces[f];
      const Vec3 &p = piece.points[a], &q = piece.points[b], &r = piece.points[c];
      const double R = distance(p, q) * distance(q, r) * distance(r, p) / (2 * norm(cross(q - p, r - p)));
      worst = std::max(worst, R / std::min({piece.psi[a], piece.psi[b], piece.psi[c]}));
      for (const Index v : faces[f]) vertices.insert(v);
    }
    std::size_t gaps = 0, unb = 0;
    for (const Index v : vertices) {
      const Index k = piece.kept[v];
      unb += !stars.bounded(k);
      gaps += !stars.bounded(k) || stars.radius(k) > 2.5 * piece.psi[v];
    }
    if (std::getenv("LIDS"))
      std::fprintf(stderr, "lid group: %zu faces, %zu vertices, worst R/psi %.2f, gaps %zu, unbounded %zu at %g %g %g\n",
                   group.size(), vertices.size(), worst, gaps, unb, piece.points[*vertices.begin()].x,
                   piece.points[*vertices.begin()].y, piece.points[*vertices.begin()].z);
    const bool lid = rule == BoundaryRule::open || (2 * gaps > vertices.size() && worst > 5);
    if (!lid) continue;
    ++lids.count;
    lids.faces.insert(lids.faces.end(), group.begin(), group.end());
    lids.places.insert(lids.places.end(), vertices.begin(), vertices.end());
  }
  std::sort(lids.faces.begin(), lids.faces.end());
  std::sort(lids.places.begin(), lids.places.end());
  return lids;
}

std::vector<Triangle> without(const std::vector<Triangle>& faces, const Lids& lids, std::size_t point_count) {
  std::vector<Triangle> left;
  for (Index f = 0; f < faces.size(); ++f)
    if (!std::binary_search(lids.faces.begin(), lids.faces.end(), f)) left.push_back(faces[f]);
  drop_minor_fans(left, point_count);
  return left;
}

}  // namespace geodrome
