// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "engine/formats/lower_extension.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/formats/number_text.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome {
namespace {

using Positions = std::span<const Vec3>;
using Triangles = std::span<const Triangle>;

void append_point(std::string& text, std::string_view before, const Vec3& p) {
  text += before;
  append_number(text, p.x);
  text += ' ';
  append_number(text, p.y);
  text += ' ';
  append_number(text, p.z);
  text += '\n';
}

void append_face(std::string& text, std::string_view before, const Triangle& triangle, Index base) {
  text += before;
  for (const Index v : triangle) text += ' ' + std::to_string(v + base);
  text += '\n';
}

template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

std::string off_text(Positions positions, Triangles triangles) {
  std::string text = "OFF\n" + std::to_string(positions.size()) + ' ' + std::to_string(triangles.size()) + " 0\n";
  for (const Vec3& p : positions) append_point(text, "", p);
  for (const Triangle& t : triangles) append_face(text, "3", t, 0);
  return text;
}

std::string obj_text(Positions positions, Triangles triangles) {
  std::string text;
  for (const Vec3& p : positions) append_point(text, "v ", p);
  for (const Triangle& t : triangles) append_face(text, "f", t, 1);
  return text;
}

std::string xyz_text(Positions positions) {
  std::string text;
  for (const Vec3& p : positions) append_point(text, "", p);
  return text;
}

std::string ply_bytes(Positions positions, Triangles triangles, std::span<const double> weights = {}) {
  // Most readers know no unsigned indices.
  const bool fits_int = positions.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(positions.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!triangles.empty())
    bytes += "element face " + std::to_string(triangles.size()) + "\nproperty list uchar " +
             (fits_int ? "int" : "uint") + " vertex_indices\n";
  if (!weights.empty()) bytes += "property double weight\n";
  bytes += "end_header\n";
  bytes.reserve(bytes.size() + sizeof(Vec3) * positions.size() + 13 * triangles.size() + 8 * weights.size());
  for (const Vec3& p : positions)
    for (const double coordinate : {p.x, p.y, p.z}) append_little_endian(bytes, coordinate);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    bytes += '\3';
    for (const Index v : triangles[f]) append_little_endian(bytes, v);
    if (!weights.empty()) append_little_endian(bytes, weights[f]);
  }
  return bytes;
}

Vec3 unit_normal(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 n = cross(q - p, r - p);
  const double length = norm(n);
  return length > 0 && std::isfinite(length) ? n / length : Vec3{};
}

std::string stl_bytes(const std::filesystem::path& file, Positions positions, Triangles triangles) {
  constexpr double largest_float = std::numeric_limits<float>::max();
  std::string bytes = "binary STL";  // must not start with "solid"
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(triangles.size()));
  const auto append = [&](const Vec3& p) {
    for (const double coordinate : {p.x, p.y, p.z}) {
      if (std::abs(coordinate) > largest_float)
        throw InputError(InputFault::range, file.string() + ": a coordinate does not fit into the floats of STL",
                         "write PLY");
      append_little_endian(bytes, static_cast<float>(coordinate));
    }
  };
  for (const Triangle& t : triangles) {
    append(unit_normal(positions[t[0]], positions[t[1]], positions[t[2]]));
    for (const Index v : t) append(positions[v]);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

[[noreturn]] void reject_ending(const std::filesystem::path& file, const std::string& known) {
  throw OptionError(file.string() + ": the ending tells no format that can be written", "use one of " + known);
}

}  // namespace

void write_mesh(const std::filesystem::path& file, const SurfaceMesh& mesh) {
  const std::string extension = lower_extension(file);
  const Positions positions = mesh.positions();
  const Triangles triangles = mesh.triangles();
  if (extension == ".ply") return write_atomically(file, ply_bytes(positions, triangles, mesh.face_weights()));
  if (!mesh.face_weights().empty())
    throw OptionError(file.string() + ": only PLY holds the weights of the faces", "write .ply");
  if (extension == ".off") return write_atomically(file, off_text(positions, triangles));
  if (extension == ".obj") return write_atomically(file, obj_text(positions, triangles));
  if (extension == ".stl") return write_atomically(file, stl_bytes(file, positions, triangles));
  reject_ending(file, ".off, .obj, .ply, .stl");
}

void write_points(const std::filesystem::path& file, const std::vector<Vec3>& points) {
  const std::string extension = lower_extension(file);
  if (extension == ".xyz") return write_atomically(file, xyz_text(points));
  if (extension == ".ply") return write_atomically(file, ply_bytes(points, {}));
  if (extension == ".off") return write_atomically(file, off_text(points, {}));
  reject_ending(file, ".xyz, .ply, .off");
}

}  // namespace geodrome
