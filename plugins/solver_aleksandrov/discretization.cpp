// SPDX-License-Identifier: MIT
#include "solver_aleksandrov/discretization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver_aleksandrov/delaunay.hpp"

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

}  // namespace

Discretization::Discretization(const FlatSurface& surface, const Settings& settings, const RunContext& context)
    : surface_(surface),
      triangulation_(triangulated(surface, settings, context)),
      graph_(triangulation_, {triangulation_, settings.placement, settings.delta, settings.thinning}) {}

SurfacePoint Discretization::located(const SurfacePoint& flat) const {
  SurfacePoint at = triangulation_.located(flat);
  const auto& face = triangulation_.face(at.face);
  const double size = *std::max_element(face.length, face.length + 3);
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double height = face.length[i] * face.sine[(i + 1) % 3];
    if (at.b[i] * height <= on_edge * size && at.b[i] < 0.5) at.b[i] = 0;
    sum += at.b[i];
  }
  for (double& b : at.b) b /= sum;
  return at;
}

}  // namespace geodrome::aleksandrov
