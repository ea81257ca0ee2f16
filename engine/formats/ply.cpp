// SPDX-License-Identifier: MIT
#include <limits>

#include "engine/formats/bytes.hpp"
#include "engine/formats/line_reader.hpp"
#include "engine/formats/ply_reader.hpp"
#include "engine/formats/table.hpp"

// Stanford's polygon format. It is read by ply_reader.cpp.
namespace geodrome {
namespace {

using input::SourceFile;

Evidence ply_evidence(const SourceFile& file) {
  return input::first_word(file) == "ply" ? Evidence::keyword : Evidence::none;
}

std::string ply_header(const MeshToWrite& mesh) {
  // Most readers know no unsigned indices.
  const bool fits_int = mesh.positions.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) + "\n";
  const char* type = mesh.scalar == ScalarType::float64 ? "double" : "float";
  for (const char* axis : {"x", "y", "z"}) header += std::string("property ") + type + " " + axis + "\n";
  if (!mesh.triangles.empty())
    header += "element face " + std::to_string(mesh.triangles.size()) + "\nproperty list uchar " +
              (fits_int ? "int" : "uint") + " vertex_indices\n";
  if (!mesh.weights.empty()) header += "property double weight\n";
  return header + "end_header\n";
}

std::string ply_bytes(const MeshToWrite& mesh) {
  std::string bytes = ply_header(mesh);
  constexpr std::size_t face_bytes = 1 + sizeof(Triangle);
  bytes.reserve(bytes.size() + sizeof(Vec3) * mesh.positions.size() + face_bytes * mesh.triangles.size() +
                mesh.weights.size_bytes());
  for (const Vec3& p : mesh.positions)
    for (const double coordinate : {p.x, p.y, p.z})
      mesh.scalar == ScalarType::float64 ? append_little_endian(bytes, coordinate)
                                         : append_float32(bytes, coordinate, mesh.file, "32-bit floats");
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    bytes += '\3';
    for (const Index v : mesh.triangles[f]) append_little_endian(bytes, v);
    if (!mesh.weights.empty()) append_little_endian(bytes, mesh.weights[f]);
  }
  return bytes;
}

}  // namespace

Format ply_format() {
  return {.name = "PLY",
          .endings = {".ply"},
          .uses = {{Content::mesh, "text, binary of both byte orders", "binary, double"},
                   {Content::points, "without faces", "binary, double"},
                   {Content::weights, "a property of the faces", "the property weight"}},
          .evidence = ply_evidence,
          .read = [](const SourceFile& file) { return input::read_ply(file, {}); },
          .read_weighted = input::read_ply,
          .write = ply_bytes,
          .mesh_numbers = MeshNumbers::either};
}

}  // namespace geodrome
