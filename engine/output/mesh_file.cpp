// SPDX-License-Identifier: MIT
#include "engine/formats/table.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/output/float32_loss.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome {

std::vector<Finding> write_mesh(const std::filesystem::path& file, const SurfaceMesh& mesh, ScalarType scalar) {
  const Format& format = mesh_format_to_write(file, !mesh.face_weights().empty(), scalar);
  write_atomically(file, format.write({file, mesh.positions(), mesh.triangles(), mesh.face_weights(), scalar}));
  const bool rounded = format.mesh_numbers == MeshNumbers::float32 || scalar == ScalarType::float32;
  return rounded ? float32_loss(file, mesh) : std::vector<Finding>();
}

void write_points(const std::filesystem::path& file, const std::vector<Vec3>& points) {
  write_atomically(file, format_to_write(file, Content::points).write({.file = file, .positions = points}));
}

}  // namespace geodrome
