// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/piece_surface.hpp"

#include <algorithm>
#include <utility>

#include "geodrome/vertex_components.hpp"
#include "plugins/reconstructor_delaunay_cut/feature_size.hpp"
#include "plugins/reconstructor_delaunay_cut/manifold_repair.hpp"

namespace geodrome {
namespace {

constexpr std::size_t most_rounds = 4;

/// Components with fewer points beside a larger one are no surfaces but pockets of a few cells.
constexpr std::size_t least_component = 20;

std::vector<Triangle> border(const Tetrahedra& tetrahedra, const Labels& inside) {
  std::vector<Triangle> faces;
  for (Index c = 0; c < tetrahedra.size(); ++c)
    for (int i = 0; i < 4 && inside[c]; ++i)
      if (!inside[tetrahedra.neighbours[c][i]]) faces.push_back(facet_of(tetrahedra.corners[c], i));
  return faces;
}

/// Turns the normals that look against the faces around their point; returns how many.
std::size_t turn_normals(const std::vector<Triangle>& faces, OrientedPiece& piece) {
  std::vector<double> vote(piece.points.size(), 0);
  for (const Triangle& t : faces) {
    const Vec3 front = cross(piece.points[t[1]] - piece.points[t[0]], piece.points[t[2]] - piece.points[t[0]]);
    const double length = norm(front);
    if (length > 0)
      for (const Index p : t) vote[p] += dot(front, piece.normals[p]) / length;
  }
  std::size_t turned = 0;
  for (Index p = 0; p < vote.size(); ++p) {
    if (vote[p] >= 0) continue;
    piece.normals[p] = -piece.normals[p];
    ++turned;
  }
  return turned;
}

std::size_t drop_bubbles(std::vector<Triangle>& faces, std::size_t point_count) {
  const std::vector<Index> component = vertex_components(faces, point_count);
  std::vector<std::size_t> size(point_count, 0);
  for (Index p = 0; p < point_count; ++p) ++size[component[p]];
  if (*std::max_element(size.begin(), size.end()) < least_component) return 0;
  return std::erase_if(faces, [&](const Triangle& t) { return size[component[t[0]]] < least_component; });
}

}  // namespace

PieceSurface cut_piece(OrientedPiece piece, const PlanarStars& stars, RunContext& context) {
  PieceSurface result;
  const Tetrahedra tetrahedra = delaunay_tetrahedra(piece.points);
  if (tetrahedra.size() == 0) return result;
  context.throw_if_cancelled();
  CutCosts costs;
  Labels inside;
  do {
    costs = cut_costs(tetrahedra, piece, stars);
    inside = cheapest_labels(tetrahedra, costs);
    context.throw_if_cancelled();
  } while (++result.rounds < most_rounds && turn_normals(border(tetrahedra, inside), piece) > 0);
  const CellsOfPoint cells_of(tetrahedra, piece.points.size());
  RepairRecord repair = make_manifold(tetrahedra, costs, cells_of, piece.points.size(), inside);
  result.flips = repair.flips;
  result.repaired = std::move(repair.places);
  result.unresolved = std::move(repair.unresolved);
  result.feature_size = feature_sizes(tetrahedra, cells_of, inside, piece);
  result.faces = border(tetrahedra, inside);
  result.bubble_faces = drop_bubbles(result.faces, piece.points.size());
  if (result.unresolved.empty()) result.gaps = find_gaps(result.faces, piece, stars);
  return result;
}

}  // namespace geodrome
