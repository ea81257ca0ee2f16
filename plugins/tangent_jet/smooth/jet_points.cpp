// SPDX-License-Identifier: MIT
#include "plugins/tangent_jet/smooth/jet_points.hpp"

namespace geodrome {
namespace {

std::vector<Vec3> origins(const Tangents& tangents) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < tangents.plane.size(); ++i)
    if (tangents.state[i] != PointState::dropped) kept.push_back(tangents.plane[i].origin);
  return kept;
}

}  // namespace

JetPoints::JetPoints(const PointSample& sample, const Tangents& tangents)
    : places(origins(tangents)), sigma(tangents.sigma) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (tangents.state[i] == PointState::dropped) continue;
    raw.push_back(sample.points[i]);
    normal.push_back(tangents.plane[i].normal);
  }
}

}  // namespace geodrome
