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

/// A 3 x 3 lattice of spacing 0.1 at a northing where float32 comes in steps of 0.5.
SurfaceMesh far_lattice() {
  std::vector<Vec3> points;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) points.push_back({0.1 * i, 5405590 + 0.1 * j, 0});
  return {points, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}}};
}

TEST(MeshWriter, StlAndPlyOfFloatsTellWhichVerticesFallTogether) {
  const TemporaryFolder folder;
  for (const char* name : {"m.stl", "m.ply"}) {
    const std::vector<Finding> told = write_mesh(folder / name, far_lattice(), ScalarType::float32);
    ASSERT_EQ(told.size(), 1u) << name;
    EXPECT_EQ(told[0].code, "float32_loss");
    EXPECT_EQ(told[0].count, 6u) << "three rows become one";
    EXPECT_NE(told[0].message.find("6 vertices fall together with others and 8 faces collapse"), std::string::npos)
        << told[0].message;
    EXPECT_NE(told[0].remedy.text.find(".ply"), std::string::npos);
  }
  for (const char* name : {"m.ply", "m.off", "m.obj"}) EXPECT_TRUE(write_mesh(folder / name, far_lattice()).empty());
}

TEST(MeshWriter, StlTellsWhenVerticesMoveThoughNoneFallTogether) {
  const TemporaryFolder folder;
  const auto triangle = [](double size) {
    return SurfaceMesh({{0, 5405590.2, 0}, {size, 5405590.2, 0}, {0, 5405590.2 + size, 0}}, {{0, 1, 2}});
  };
  const std::vector<Finding> told = write_mesh(folder / "m.stl", triangle(2));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].message.find("move vertices by up to 0.2, 10 % of the median edge"), std::string::npos)
      << told[0].message;
  EXPECT_TRUE(write_mesh(folder / "m.stl", triangle(100)).empty());
}

TEST(MeshWriter, WhatFallsTogetherBeforehandIsNoLoss) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {-0.0, 1.1, 0}}, {{0, 1, 2}, {3, 2, 4}});
  EXPECT_TRUE(write_mesh(folder / "m.stl", mesh).empty());
  const SurfaceMesh tiny({{0, 0, 0}, {1e-60, 0, 0}, {0, 1e-60, 0}}, {{0, 1, 2}});
  EXPECT_EQ(write_mesh(folder / "m.stl", tiny).size(), 1u) << "all is 0 in floats";
}

TEST(MeshWriter, PlyOfFloatsHoldsThem) {
  const TemporaryFolder folder;
  const SurfaceMesh mesh({{0.1, 0, 0}, {1, 0.7, 0}, {0, 1, -0.3}}, {{0, 1, 2}});
  write_mesh(folder / "m.ply", mesh, ScalarType::float32);
  std::ifstream file(folder / "m.ply", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(bytes.find("property float x\nproperty float y\nproperty float z\n"), std::string::npos);
  const Input input = read_input(folder / "m.ply");
  for (Index v = 0; v < 3; ++v) {
    EXPECT_EQ(input.positions[v].x, float(mesh.positions()[v].x));
    EXPECT_EQ(input.positions[v].y, float(mesh.positions()[v].y));
    EXPECT_EQ(input.positions[v].z, float(mesh.positions()[v].z));
  }
  EXPECT_EQ(input.triangles.size(), 1u);
  EXPECT_THROW(write_mesh(folder / "m.off", mesh, ScalarType::float32), OptionError);
  const SurfaceMesh large({{0, 0, 0}, {1e50, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  expect_refused([&] { write_mesh(folder / "l.ply", large, ScalarType::float32); }, InputFault::range, "l.ply");
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
