// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/corner_angles.hpp"

#include <cmath>

namespace geodrome::chen_han {

CornerAngles::CornerAngles(const PackedMesh& surface)
    : angle_(3 * surface.face_count()), start_(angle_.size()), total_(surface.vertex_count()) {
  for (Index corner = 0; corner < angle_.size(); ++corner) {
    const PackedMesh::Face& face = surface.face_of(corner);
    angle_[corner] = bearing_of(std::atan2(face.sine[corner % 3], face.cosine[corner % 3]));
  }
  for (Index vertex = 0; vertex < surface.vertex_count(); ++vertex) {
    if (surface.kind(vertex) == PackedMesh::VertexKind::irregular) continue;
    double total = 0;
    for (const Index corner : surface.corners(vertex)) total += radians(angle_[corner]);
    if (total > largest_angle) continue;
    total_[vertex] = total;
    Bearing start = 0;
    for (const Index corner : surface.corners(vertex)) start_[corner] = start, start += angle_[corner];
  }
}

double CornerAngles::direction(Index corner, Angle side) const {
  return radians(start_[corner]) + std::atan2(side.sine, side.cosine);
}

}  // namespace geodrome::chen_han
