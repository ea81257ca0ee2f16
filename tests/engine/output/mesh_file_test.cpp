// SPDX-License-Identifier: MIT
#include <bit>
#include <random>

#include "geodrome/surface.hpp"
#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

// Doubles of all magnitudes, none of them a float.
std::vector<Vec3> random_points(std::size_t count) {
  std::mt19937_64 random(99);
  const auto number = [&] {
    const double mantissa = 1 + double(random() >> 11) * 0x1p-53;
    return std::ldexp(random() % 2 ? -mantissa : mantissa, int(random() % 120) - 60);
  };
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = number(), y = number(), z = number();
    points.push_back({x, y, z});
  }
  points[0].x = -0.0;
  return points;
}

void expect_same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  ASSERT_EQ(a.size(), b.size());
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(bits(a[i].x), bits(b[i].x));
    EXPECT_EQ(bits(a[i].y), bits(b[i].y));
    EXPECT_EQ(bits(a[i].z), bits(b[i].z));
  }
}

SurfaceMesh random_mesh() {
  std::vector<Triangle> strip;
  for (Index v = 0; v + 2 < 50; ++v) strip.push_back({v, v + 1, v + 2});
  return {random_points(51), strip};  // the last vertex is on no face
}

TEST(MeshWriter, OffObjAndPlyGiveTheSameBitsBack) {
  const SurfaceMesh mesh = random_mesh();
  const TemporaryFolder folder;
  for (const char* name : {"m.off", "m.obj", "m.PLY"}) {
    SCOPED_TRACE(name);
    write_mesh(folder / name, mesh);
    const Input input = read_input(folder / name);
    expect_same_bits(input.positions, {mesh.positions().begin(), mesh.positions().end()});
    EXPECT_EQ(input.triangles, std::vector<Triangle>(mesh.triangles().begin(), mesh.triangles().end()));
  }
}

TEST(MeshWriter, StlKeepsTheTrianglesAsFloats) {
  const SurfaceMesh mesh = random_mesh();
  const TemporaryFolder folder;
  write_mesh(folder / "m.stl", mesh);
  const Input input = read_input(folder / "m.stl");
  ASSERT_EQ(input.triangles.size(), mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (int i = 0; i < 3; ++i) EXPECT_EQ(input.positions[input.triangles[f][i]].x, float(mesh.corners(f)[i].x));
}

TEST(MeshWriter, StlRefusesWhatFloatsCannotHold) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh({{0, 0, 0}, {1e50, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  expect_refused([&] { write_mesh(folder / "m.stl", mesh); }, InputFault::range, "m.stl");
  EXPECT_FALSE(std::filesystem::exists(folder / "m.stl"));
}

TEST(PointWriter, XyzPlyAndOffGiveTheSameBitsBack) {
  const std::vector<Vec3> points = random_points(40);
  const TemporaryFolder folder;
  for (const char* name : {"p.xyz", "p.ply", "p.off"}) {
    SCOPED_TRACE(name);
    write_points(folder / name, points);
    const Input input = read_input(folder / name);
    EXPECT_EQ(input.kind, InputKind::points);
    expect_same_bits(input.positions, points);
  }
}

TEST(MeshWriter, UnknownEndingsNameTheKnownOnes) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_mesh(folder / "m.xyz", random_mesh()), OptionError);
  EXPECT_THROW(write_points(folder / "p.stl", {{0, 0, 0}}), OptionError);
}

TEST(MeshWriter, AFailedWriteNamesTheFileAndLeavesNothing) {
  const TemporaryFolder folder;
  expect_refused([&] { write_mesh(folder / "missing" / "m.ply", random_mesh()); }, InputFault::io, "missing/m.ply");
  std::filesystem::create_directory(folder / "m.ply");
  expect_refused([&] { write_mesh(folder / "m.ply", random_mesh()); }, InputFault::io, "m.ply");
}

TEST(MeshWriter, AnExistingFileIsReplacedAndNoTemporaryStays) {
  const TemporaryFolder folder;
  write_points(folder / "p.xyz", {{1, 2, 3}});
  write_points(folder / "p.xyz", {{4, 5, 6}});
  EXPECT_EQ(read_input(folder / "p.xyz").positions[0], (Vec3{4, 5, 6}));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace geodrome::testing
