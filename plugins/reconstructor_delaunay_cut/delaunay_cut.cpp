// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "plugins/common/cell_radius.hpp"
#include "plugins/common/manifold_faces.hpp"
#include "plugins/common_gpl/planar_triangles.hpp"
#include "plugins/reconstructor_delaunay_cut/lids.hpp"
#include "plugins/reconstructor_delaunay_cut/manifold_repair.hpp"
#include "plugins/reconstructor_delaunay_cut/orient_normals.hpp"

namespace geodrome {
namespace {

struct Clock {
  std::chrono::steady_clock::time_point t = std::chrono::steady_clock::now();
  void lap(const char* what) {
    auto now = std::chrono::steady_clock::now();
    if (std::getenv("LAPS")) std::fprintf(stderr, "%s %.2f s\n", what, std::chrono::duration<double>(now - t).count());
    t = now;
  }
};

std::vector<Triangle> border(const Tetrahedra& tetrahedra, const Labels& inside) {
  std::vector<Triangle> faces;
  for (Index c = 0; c < tetrahedra.size(); ++c)
    for (int i = 0; i < 4 && inside[c]; ++i)
      if (!inside[tetrahedra.neighbours[c][i]]) faces.push_back(facet_of(tetrahedra.corners[c], i));
  return faces;
}

std::size_t turn_with_border(const Tetrahedra& tetrahedra, const Labels& inside, OrientedPiece& piece) {
  std::vector<double> vote(piece.points.size(), 0);
  std::vector<int> count(piece.points.size(), 0);
  for (const auto& [a, b, c] : border(tetrahedra, inside)) {
    const Vec3 away = cross(piece.points[b] - piece.points[a], piece.points[c] - piece.points[a]);
    for (const Index p : {a, b, c}) vote[p] += dot(away, piece.normals[p]) / norm(away), ++count[p];
  }
  static const double vt = std::getenv("VT") ? std::atof(std::getenv("VT")) : 0.2;
  std::size_t turned = 0;
  for (Index p = 0; p < vote.size(); ++p)
    if (vote[p] < -vt * count[p] && count[p] > 0) piece.normals[p] = -piece.normals[p], ++turned;
  return turned;
}

}  // namespace

Reconstruction DelaunayCut::reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                                        std::span<const Index> kept, RunContext& context) const {
  if (kept.size() < 4) throw SampleError("few");
  Clock clock;
  std::vector<Vec3> points, normals;
  std::vector<double> psi;
  for (const Index i : kept) {
    points.push_back(sample.points[i]);
    normals.push_back(tangents.plane[i].normal);
    psi.push_back(control.psi[i]);
  }
  const Neighbours neighbours(points);
  const PlanarStars stars(neighbours, normals, sample_reach(points), context, {0, 0.3});
  clock.lap("stars");
  const StarAgreement agree = agreement(stars, neighbours);
  clock.lap("agreement");
  OrientedSample oriented = orient(stars, points, normals, psi, FaceRule::edge_bound);
  clock.lap("orient");
  if (std::getenv("LAPS")) std::fprintf(stderr, "inconsistent %.4f ties %.4f pieces %zu\n", agree.inconsistent, agree.ties, oriented.pieces.size());
  if (const char* dump = std::getenv("DUMP")) {
    std::FILE* out = std::fopen(dump, "w");
    for (std::size_t i = 0; i < points.size(); ++i)
      std::fprintf(out, "%u %.9g %.9g %.9g %.6g %.6g %.6g %.6g %.6g %d\n", kept[i], points[i].x, points[i].y, points[i].z, oriented.normals[i].x, oriented.normals[i].y, oriented.normals[i].z, psi[i], stars.radius(i), (int)control.state[kept[i]]);
    std::fclose(out);
  }
  std::vector<Triangle> faces;
  std::size_t flips = 0, unresolved = 0, lid_count = 0;
  for (const auto& members : oriented.pieces) {
    if (members.size() < 4) continue;
    OrientedPiece piece;
    for (const Index k : members) {
      piece.points.push_back(points[k]);
      piece.normals.push_back(oriented.normals[k]);
      piece.psi.push_back(psi[k]);
      piece.kept.push_back(k);
    }
    const Tetrahedra tetrahedra = delaunay_tetrahedra(piece.points);
    clock.lap("delaunay");
    CutCosts costs;
    Labels inside;
    for (int round = 0; round < 5; ++round) {
      costs = cut_costs(tetrahedra, piece, stars);
      clock.lap("costs");
      inside = cheapest_labels(tetrahedra, costs);
      clock.lap("cut");
      const std::size_t turned = turn_with_border(tetrahedra, inside, piece);
      if (std::getenv("LAPS")) std::fprintf(stderr, "round %d inconsistent, turned %zu\n", round, turned);
      if (turned == 0) break;
    }
    const CellsOfPoint cells_of(tetrahedra, piece.points.size());
    const RepairRecord repair = make_manifold(tetrahedra, costs, cells_of, piece.points.size(), inside);
    clock.lap("repair");
    if (std::getenv("CELLS")) {
      Index v = static_cast<Index>(std::atoi(std::getenv("CELLS")));
      for (Index p = 0; p < piece.kept.size(); ++p) if (kept[piece.kept[p]] == v)
        for (Index c : cells_of(p)) {
          std::fprintf(stderr, "cell inf %d in %d cost %d cut %d %d %d %d nb", tetrahedra.infinite(c), inside[c], costs.inside[c], costs.cut[c][0], costs.cut[c][1], costs.cut[c][2], costs.cut[c][3]);
          for (int i = 0; i < 4; ++i) std::fprintf(stderr, " %d", inside[tetrahedra.neighbours[c][i]]);
          for (Index q : tetrahedra.corners[c]) if (q != no_index) std::fprintf(stderr, " (%.3f %.3f %.3f)", piece.points[q].x, piece.points[q].y, piece.points[q].z);
          std::fprintf(stderr, "\n");
        }
    }
    flips += repair.flips, unresolved += repair.unresolved.size();
    std::vector<Triangle> here = border(tetrahedra, inside);
    const Lids lids = find_lids(here, piece, stars, boundary_ == "open" ? BoundaryRule::open : BoundaryRule::automatic);
    here = without(here, lids, piece.points.size());
    lid_count += lids.count;
    for (Triangle t : here) {
      for (Index& v : t) v = piece.kept[v];
      faces.push_back(t);
    }
    clock.lap("border");
  }
  Reconstruction result;
  std::vector<Index> vertex_of(points.size(), no_index);
  for (const Triangle& t : faces)
    for (const Index p : t) vertex_of[p] = 0;
  std::vector<Vec3> positions;
  for (Index p = 0; p < points.size(); ++p) {
    if (vertex_of[p] == no_index) continue;
    vertex_of[p] = static_cast<Index>(positions.size());
    positions.push_back(points[p]);
    result.sample_of_vertex.push_back(kept[p]);
  }
  for (Triangle& t : faces)
    for (Index& p : t) p = vertex_of[p];
  if (faces.empty()) throw SampleError("no faces");
  if (std::getenv("LAPS"))
    std::fprintf(stderr, "flips %zu unresolved %zu unused %zu of %zu lids %zu\n", flips, unresolved,
                 points.size() - positions.size(), points.size(), lid_count);
  result.mesh = std::make_shared<const SurfaceMesh>(std::move(positions), std::move(faces));
  clock.lap("mesh");
  return result;
}

}  // namespace geodrome
