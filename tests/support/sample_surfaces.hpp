// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "geodrome/engine/pipeline.hpp"
#include "tests/support/meshes.hpp"

/// What stages 1 to 4 would have given, put together by hand: for tests of what is told about it.
namespace geodrome::test {

/// A cloud and the surface made from it.
struct SampledSurface {
  Input input;
  PlacedSurface surface;
};

inline StageRecord record_of(const char* stage, const char* name, std::map<std::string, double> measures) {
  StageRecord record;
  record.plugin.stage = stage, record.plugin.name = name;
  record.measures = std::move(measures);
  return record;
}

/// Every vertex of `mesh` is a point of the cloud, kept, with this phi and psi, and a tangent plane across the z-axis.
inline SampledSurface sampled(MeshPtr mesh, double psi) {
  SampledSurface made;
  const std::size_t n = mesh->vertex_count();
  made.input.kind = made.surface.made_from = InputKind::points;
  made.input.positions.assign(mesh->positions().begin(), mesh->positions().end());
  made.input.facts.rows = n, made.input.facts.bounding_box_diagonal = 2;
  SampleStages& stages = made.surface.sample.emplace();
  stages.smoothed.points = made.input.positions;
  stages.tangents.state.assign(n, PointState::ok), stages.control.state.assign(n, PointState::ok);
  stages.control.phi.assign(n, psi), stages.control.psi.assign(n, psi);
  for (Index i = 0; i < n; ++i) {
    made.input.element_of_row.push_back(i);
    stages.tangents.plane.push_back({mesh->positions()[i], {0, 0, 1}, 0});
    stages.kept.push_back(i), stages.sample_of_vertex.push_back(i);
    made.surface.places.push_back({Place::State::on_surface, mesh->at_vertex(i), i, mesh->positions()[i]});
  }
  made.surface.mesh = std::move(mesh);
  made.surface.stages = {record_of("tangent", "a", {}), record_of("control", "b", {}), record_of("decimator", "c", {}),
                         record_of("reconstructor", "d", {})};
  return made;
}

/// Takes surface and places away, as if the reconstructor had refused the sample.
inline void refuse(SampledSurface& made) {
  made.surface.mesh = nullptr;
  made.surface.places.clear(), made.surface.sample->sample_of_vertex.clear();
}

}  // namespace geodrome::test
