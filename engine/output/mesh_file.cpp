// SPDX-License-Identifier: MIT
#include "engine/formats/table.hpp"
#include "engine/output/atomic_file.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome {

void write_mesh(const std::filesystem::path& file, const SurfaceMesh& mesh) {
  const Format& format = mesh_format_to_write(file, !mesh.face_weights().empty());
  write_atomically(file, format.write({file, mesh.positions(), mesh.triangles(), mesh.face_weights()}));
}

void write_points(const std::filesystem::path& file, const std::vector<Vec3>& points) {
  write_atomically(file, format_to_write(file, Content::points).write({.file = file, .positions = points}));
}

}  // namespace geodrome
