// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/discretization.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "geodrome/errors.hpp"
#include "plugins/solver_aleksandrov/intrinsic/delaunay.hpp"

namespace geodrome::aleksandrov {
namespace {

/// The length of edges that have none; about 1 is the mean edge. Distances grow by as much, which is rounding.
constexpr double tiny = 1e-14;
/// Nearer to an edge than this share of the face's size, a place is on it.
constexpr double edge_tolerance = 4e-15;

/// A graph of so many nodes takes about 2 GB, and every search over it 4 GB more.
constexpr double most_nodes = 1e8;
/// To compare so many edges takes a search a quarter of an hour or more.
constexpr double most_edges = 1e11;

double edges(const IntrinsicTriangulation& triangulation, const Settings& settings) {
  return edge_count(triangulation, {triangulation, settings.placement, settings.delta, settings.thinning});
}

std::string shown(double count) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, count, std::chars_format::general, 3).ptr};
}

/// Options that are in use already help no more.
std::string remedy(const IntrinsicTriangulation& triangulation, const Settings& settings) {
  std::string text;
  if (settings.triangulation != Triangulation::refined) text += "triangulation=refined, ";
  if (settings.delta < 1) text += "a delta above " + shown(settings.delta) + ", ";
  if (!triangulation.weighted()) text += "an exact solver, ";
  return text + "or a mesh without faces that thin";
}

/// The placement, unless a search would take too much of memory or time.
SteinerPlacement placed(const IntrinsicTriangulation& triangulation, const Settings& settings) {
  SteinerPlacement placement(triangulation, settings.placement, settings.delta, settings.thinning);
  const double nodes = node_count(triangulation, placement), edges = edge_count(triangulation, placement);
  if (!(nodes < most_nodes && edges < most_edges))
    throw RefusedError("this surface takes " + shown(nodes) + " Steiner points and " + shown(edges) +
                           " edges between them, of which " + shown(most_nodes) + " and " + shown(most_edges) +
                           " are bearable: it has very many triangles, or very thin ones",
                       remedy(triangulation, settings));
  return placement;
}

/// Refinement pays where thin faces can be had rid of, not where the surface is a thin strip: then it makes many.
IntrinsicTriangulation triangulated(const PackedMesh& surface, const Settings& settings, const RunContext& context) {
  IntrinsicTriangulation flipped(surface, tiny);
  if (settings.triangulation == Triangulation::as_is) return flipped;
  make_delaunay(flipped, context);
  if (settings.triangulation == Triangulation::flipped) return flipped;
  IntrinsicTriangulation refined = flipped;
  const Index most = 100000 + 10 * std::min<Index>(refined.face_count(), 100000000);
  if (refine(refined, settings.least_angle * std::numbers::pi / 180, most, context) == 0) return flipped;
  return edges(refined, settings) < edges(flipped, settings) ? refined : flipped;
}

/// Straight to the side opposite to corner i, if that is within `close`; false if not, or if it would miss the side.
bool move_to_side(const IntrinsicTriangulation::Face& face, int i, double close, Barycentric& b) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  if (b[i] * face.length[i] * face.sine[j] > close) return false;
  const double share = b[k] + b[i] * face.length[i] * face.cosine[j] / face.length[j];
  if (!(share >= 0 && share <= 1)) return false;
  b[i] = 0, b[j] = 1 - share, b[k] = share;
  return true;
}

}  // namespace

Discretization::Discretization(const PackedMesh& surface, const Settings& settings, const RunContext& context)
    : surface_(surface),
      triangulation_(triangulated(surface, settings, context)),
      graph_(triangulation_, placed(triangulation_, settings)) {}

SurfacePoint Discretization::located(const SurfacePoint& flat) const {
  SurfacePoint at = triangulation_.located(flat);
  const auto& face = triangulation_.face(at.face);
  const double close = edge_tolerance * *std::max_element(face.length, face.length + 3);
  int side = static_cast<int>(std::find(at.b.begin(), at.b.end(), 0.0) - at.b.begin());
  for (int i = 0; i < 3 && side == 3; ++i)
    if (move_to_side(face, i, close, at.b)) side = i;
  if (side == 3) return at;
  // Only along the side: in a face without area all places are near all sides.
  const int j = (side + 1) % 3, k = (side + 2) % 3;
  for (const int end : {j, k})
    if (at.b[end] * face.length[j] <= close && at.b[end] < 0.5) at.b[end] = 0, at.b[end == j ? k : j] = 1;
  return at;
}

}  // namespace geodrome::aleksandrov
