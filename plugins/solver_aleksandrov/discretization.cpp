// SPDX-License-Identifier: MIT
#include "solver_aleksandrov/discretization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver_aleksandrov/intrinsic/delaunay.hpp"

namespace geodrome::aleksandrov {
namespace {

/// The length of edges that have none; about 1 is the mean edge. Distances grow by as much, which is rounding.
constexpr double tiny = 1e-14;
/// Nearer to an edge than this share of the face's size, a place is on it.
constexpr double on_edge = 4e-15;

double edges(const IntrinsicTriangulation& triangulation, const Settings& settings) {
  return edge_count(triangulation, {triangulation, settings.placement, settings.delta, settings.thinning});
}

/// Refinement pays where thin faces can be had rid of, not where the surface is a thin strip: then it makes many.
IntrinsicTriangulation triangulated(const FlatSurface& surface, const Settings& settings, const RunContext& context) {
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

Discretization::Discretization(const FlatSurface& surface, const Settings& settings, const RunContext& context)
    : surface_(surface),
      triangulation_(triangulated(surface, settings, context)),
      graph_(triangulation_, {triangulation_, settings.placement, settings.delta, settings.thinning}) {}

SurfacePoint Discretization::located(const SurfacePoint& flat) const {
  SurfacePoint at = triangulation_.located(flat);
  const auto& face = triangulation_.face(at.face);
  const double close = on_edge * *std::max_element(face.length, face.length + 3);
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
