// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A vertex's place; isolated if no face uses it, dropped for no_index.
inline Place place_of_vertex(const SurfaceMesh& mesh, Index vertex) {
  if (vertex == no_index) return {};
  if (mesh.first_half_edge(vertex) == no_index) return {Place::State::isolated, {}, vertex, mesh.positions()[vertex]};
  return {Place::State::on_surface, mesh.at_vertex(vertex), vertex, mesh.positions()[vertex]};
}

/// The place of a point that lies at `at` or, for a cloud, beside it.
inline Place place_on(const SurfaceMesh& mesh, const SurfacePoint& at, const Vec3& position) {
  return {Place::State::on_surface, at, mesh.vertex_at(at), position};
}

}  // namespace geodrome
