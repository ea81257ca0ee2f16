// SPDX-License-Identifier: MIT
#include "tests/fuzzing/mesh_seeds.hpp"

#include <algorithm>

#include "engine/formats/table.hpp"
#include "tests/fuzzing/mesh_promises.hpp"
#include "tests/fuzzing/target.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::fuzzing {
namespace {

using namespace shapes::small;

/// The first faces of a random mesh, and their vertices.
MeshPtr part_of_random_mesh(std::uint64_t seed) {
  constexpr std::size_t faces = 12;
  const SurfaceMesh whole = shapes::fuzz_mesh(seed).mesh;
  std::vector<Index> number(whole.vertex_count(), no_index);
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles(whole.triangles().begin(), whole.triangles().begin() + faces);
  for (Triangle& t : triangles)
    for (Index& v : t) {
      if (number[v] == no_index)
        number[v] = static_cast<Index>(positions.size()), positions.push_back(whole.positions()[v]);
      v = number[v];
    }
  return make(std::move(positions), std::move(triangles));
}

std::vector<MeshPtr> meshes() {
  std::vector<MeshPtr> all{cube(), octahedron(), bow_tie(), book(), fan(5, 1), plane_grid(1), seam(2, 1)};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) all.push_back(part_of_random_mesh(seed));
  return all;
}

const std::vector<std::string> off_texts{
    "OFF\n# a comment\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
    "COFF 3 1 3\n0 0 0 255 0 0 1\n1e0 0 0 0 255 0 1\n+0.5 1 -0. 0 0 255 1\n3 0 1 2 0.5 0.5 0.5\n",
    "OFF3 1\n0 0 0\n\n1 0 0 # b\n0 1 nan\n3\t0\t1\t2\n", "OFF\n3 0 0\n1e-310 inf 0\n1 2 3\n1e308 -1e308 4\n"};
const std::vector<std::string> obj_texts{
    "# c\no cube\nv 0 0 0\nv 1 0 0 1\nv 0 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\ns off\n",
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\nl 1 2\np 1\n",
    "f 1 2 \\\n3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\\\n", "v 0 0 0\nv 1 2 3\n"};
const std::vector<std::string> ply_texts{
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
    "z\nproperty "
    "uchar red\nelement face 2\nproperty list uchar int vertex_indices\nproperty double weight\nend_header\n0 0 0 1\n"
    "1 0 0 2\n0 1 0.5 3\n1 1 1 4\n3 0 1 2 1.5\n4 0 1 3 2 2e3\n",
    "ply\nformat ascii 1.0\nelement edge 1\nproperty int a\nelement vertex 1\nproperty double z\nproperty double x\n"
    "property double y\nend_header\n7\n1 2 3\n",
    "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\nproperty short z\n"
    "element face 1\nproperty list uchar uchar vertex_index\nproperty float weight\nend_header\n" +
        std::string("\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\3\0\1\2\x3f\x80\0\0", 26)};
const std::vector<std::string> stl_texts{
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "s\n",
    "SOLID\nsolid\n", "solid a\nendsolid\nsolid b\nendsolid b\n"};
const std::vector<std::string> xyz_texts{"0 0 0\n1 2.5 3e-1\n# c\n-4 5 6\n", "1 2 3 0 0 1\n4 5 6 0 1 0\n",
                                         "nan 0 0\n1 1 1\n1 1 1\n",
                                         "\xEF\xBB\xBF"
                                         "1 2 3\r\n4 5 6\r\n"};

const std::vector<std::string> csv_texts{"x,y,z\n0,0,0\n1,2.5,3e-1\n",   "id;z;y;x\n7;1;2;3\n8;4;5;6\n",
                                         "0,0,0,1\n1,1,1,2,\n",          "\"x\",\"y\",\"z\"\n\"1\",\"2\",\"3\"\n",
                                         "//X Y Z Intensity\n1 2 3 4\n", "2\n1\t2\t3\n4\t5\t6\n"};

struct Texts {
  std::string_view format;
  const std::vector<std::string>& texts;
};

std::vector<Texts> all_texts() {
  return {{"OFF", off_texts}, {"OBJ", obj_texts}, {"PLY", ply_texts},
          {"STL", stl_texts}, {"XYZ", xyz_texts}, {"CSV", csv_texts}};
}

void append_meshes(const Format& format, std::vector<std::string>& files) {
  for (const MeshPtr& mesh : meshes()) {
    if (format.writes(Content::mesh)) files.push_back(format.write({"m", mesh->positions(), mesh->triangles(), {}}));
    if (format.writes(Content::points)) files.push_back(format.write({.file = "m", .positions = mesh->positions()}));
  }
}

/// The same small mesh in the three encodings of PLY.
void append_encodings(std::vector<std::string>& files) {
  const MeshPtr mesh = octahedron();
  input::Soup soup;
  soup.positions.assign(mesh->positions().begin(), mesh->positions().end());
  for (const Triangle& t : mesh->triangles()) {
    soup.corners.insert(soup.corners.end(), t.begin(), t.end());
    soup.face_end.push_back(soup.corners.size());
  }
  for (const PlyText encoding : {PlyText::ascii, PlyText::little_endian, PlyText::big_endian})
    files.push_back(ply_of(soup, encoding));
}

}  // namespace

std::vector<std::string> mesh_seeds(std::string_view name) {
  std::vector<std::string> files;
  for (const auto& [format, texts] : all_texts()) {
    if (!name.empty() && name != format) continue;
    files.insert(files.end(), texts.begin(), texts.end());
    if (format == "PLY") append_encodings(files);
    for (const Format& f : formats())
      if (f.name == format) append_meshes(f, files);
  }
  // Choices in turn, so that all of them occur.
  unsigned choices = 0;
  for (std::string& file : files) file.insert(file.begin(), static_cast<char>(choices++ * 37));
  return files;
}

}  // namespace geodrome::fuzzing
