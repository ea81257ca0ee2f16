// SPDX-License-Identifier: MIT
#include <bit>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
const std::vector<Triangle> halves = {{0, 1, 2}, {0, 2, 3}};

void expect_square(const Input& input, const std::string& format) {
  EXPECT_EQ(input.format, format);
  EXPECT_EQ(input.positions, square);
  EXPECT_EQ(input.triangles, halves);
}

const std::string ply_header =
    "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 2\nproperty list uchar int vertex_index\nend_header\n";
const std::string ply_vertices = "0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n";

TEST(InputOff, PlainFile) {
  expect_square(read_bytes("s.off", "OFF\n4 2 0\n" + ply_vertices + "3 0 1 2\n3 0 2 3\n"), "off");
}

TEST(InputOff, ColouredVerticesAndFaces) {
  expect_square(read_bytes("s.off",
                           "COFF\n4 2 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n1 1 .5 1 1 1 1\n0 1 0 1 1 1 1\n"
                           "3 0 1 2 0.5 0.5 0.5\n3 0 2 3\n"),
                "off");
}

TEST(InputOff, CountsOnTheLineOfTheKeyword) {
  expect_square(read_bytes("s.off", "OFF4 2 0\n" + ply_vertices + "3 0 1 2\n3 0 2 3\n"), "off");
  expect_square(read_bytes("s.off", "OFF 4 2 0\n" + ply_vertices + "3 0 1 2\n3 0 2 3\n"), "off");
}

TEST(InputOff, MissingKeywordIsNamed) {
  expect_refused([] { read_bytes("s.off", "4 2 0\n0 0 0\n"); }, InputFault::syntax, "OFF");
}

TEST(InputOff, BinaryAndOtherDimensionsAreUnsupported) {
  expect_refused([] { read_bytes("s.off", "OFF BINARY\n4 2 0\n"); }, InputFault::unsupported, "binary");
  expect_refused([] { read_bytes("s.off", "4OFF\n1 0 0\n0 0 0 0\n"); }, InputFault::unsupported, "dimensions");
}

TEST(InputOff, FaceThatEndsTooEarlyIsNamedByItsLine) {
  expect_refused([] { read_bytes("s.off", "OFF\n4 2 0\n" + ply_vertices + "3 0 1\n3 0 2 3\n"); }, InputFault::syntax,
                 "line 7");
}

TEST(InputOff, DataAfterTheEndAreReported) {
  EXPECT_TRUE(has_finding(read_bytes("s.off", "OFF\n1 0 0\n0 0 0\n1 1 1\n"), "trailing_data"));
}

TEST(InputObj, CornersWithTextureAndNormal) {
  expect_square(read_bytes("s.obj",
                           "o square\nv 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nvn 0 0 1\nvt 0 0\nusemtl m\n"
                           "f 1/1/1 2/1/1 3/1\nf 1//1 3//1 4//1\n"),
                "obj");
}

TEST(InputObj, ContinuedLinesAreJoined) {
  expect_square(read_bytes("s.obj", "v 0 0 \\\n0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nf 1 2\\\r\n 3\nf 1 3 4\n"), "obj");
}

TEST(InputObj, FacesMayStandBeforeTheirVertices) {
  expect_square(read_bytes("s.obj", "f 1 2 3\nf 1 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\n"), "obj");
}

TEST(InputObj, IndexZeroIsRefused) {
  expect_refused([] { read_bytes("s.obj", "v 0 0 0\nf 0 1 1\n"); }, InputFault::index, "line 2");
}

TEST(InputObj, RelativeIndexBeforeTheFirstVertexIsRefused) {
  expect_refused([] { read_bytes("s.obj", "v 0 0 0\nf -1 -2 -1\n"); }, InputFault::index, "face 0");
}

TEST(InputObj, LinesAndCurvesAreReported) {
  EXPECT_TRUE(has_finding(read_bytes("s.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n"), "ignored_records"));
}

TEST(InputPly, Text) { expect_square(read_bytes("s.ply", ply_header + ply_vertices + "3 0 1 2\n3 0 2 3\n"), "ply"); }

TEST(InputPly, LineWithTooManyValuesIsRefused) {
  expect_refused([] { read_bytes("s.ply", ply_header + "0 0 0 7\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"); },
                 InputFault::syntax, "line 11");
}

TEST(InputPly, FurtherElementsAndPropertiesArePassedOver) {
  std::string bytes =
      "ply\r\nformat binary_little_endian 1.0\r\nelement camera 1\r\nproperty list uchar float view\r\nproperty short "
      "id\r\n"
      "element vertex 1\r\nproperty uchar red\r\nproperty float32 z\r\nproperty int16 y\r\nproperty float64 x\r\n"
      "element nothing 4000000000\r\nend_header\r\n";
  bytes += std::string("\2", 1) + std::string(8, 'v') + "id";
  bytes += '\xFF';
  const auto append = [&](auto value) {
    const auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
    bytes.append(raw.data(), raw.size());
  };
  append(2.5f), append(std::int16_t{-3}), append(1e10);
  const Input input = read_bytes("s.ply", bytes);
  EXPECT_EQ(input.positions, (std::vector<Vec3>{{1e10, -3, 2.5}}));
  EXPECT_FALSE(has_warning(input));
}

TEST(InputPly, HeaderErrorsNameTheirLine) {
  expect_refused([] { read_bytes("s.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n"); },
                 InputFault::syntax, "line 4");
  expect_refused([] { read_bytes("s.ply", "ply\nformat morse 1.0\n"); }, InputFault::syntax, "line 2");
  expect_refused([] { read_bytes("s.ply", "ply\nformat ascii 1.0\n"); }, InputFault::truncated, "header");
}

TEST(InputPly, MissingMagicIsNamed) {
  expect_refused([] { read_bytes("s.ply", "hello\n"); }, InputFault::syntax, "'ply'");
}

TEST(InputStl, TextIsWeldedInOrderOfAppearance) {
  const std::string facet = "facet normal 0 0 1\nouter loop\n", end = "endloop\nendfacet\n";
  const Input input =
      read_bytes("s.stl", "solid s\n" + facet + "vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0.5\n" + end + facet +
                              "vertex 0 0 0\nvertex 1 1 .5\nvertex -0 1 0\n" + end + "endsolid s\n");
  expect_square(input, "stl");
  EXPECT_FALSE(has_warning(input));
}

TEST(InputStl, TextWithoutItsEndIsTruncated) {
  expect_refused([] { read_bytes("s.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"); },
                 InputFault::truncated, "solid");
}

TEST(InputStl, TextOutOfOrderIsRefused) {
  expect_refused([] { read_bytes("s.stl", "solid s\nfacet normal 0 0 1\nvertex 0 0 0\n"); }, InputFault::syntax,
                 "line 3");
}

TEST(InputStl, BinaryThatStartsWithSolidIsToldByItsSize) {
  std::string bytes = "solid made by a careless writer";
  bytes.resize(84, ' ');
  bytes[80] = 1, bytes[81] = bytes[82] = bytes[83] = 0;
  const float values[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.append(reinterpret_cast<const char*>(values), sizeof values).append(2, '\0');
  EXPECT_EQ(read_bytes("s.stl", bytes).triangles, (std::vector<Triangle>{{0, 1, 2}}));
}

TEST(InputFormat, ContentBeatsTheNameAndIsReported) {
  EXPECT_TRUE(has_finding(read_bytes("s.obj", "OFF\n1 0 0\n0 0 0\n"), "format_by_content"));
  EXPECT_EQ(read_bytes("noname", "OFF\n1 0 0\n0 0 0\n").format, "off");
}

TEST(InputFormat, UnknownNameAndContentAreRefused) {
  expect_refused([] { read_bytes("s.vtk", "# vtk DataFile Version 3.0\n"); }, InputFault::unsupported, "s.vtk");
}

TEST(InputFormat, MissingFileIsNamed) {
  expect_refused([] { read_input("/nowhere/at/all.ply"); }, InputFault::io, "/nowhere/at/all.ply");
}

TEST(InputFormat, ByteOrderMarkIsPassedOver) {
  EXPECT_EQ(read_bytes("s.xyz",
                       "\xEF\xBB\xBF"
                       "1 2 3\n")
                .positions[0],
            (Vec3{1, 2, 3}));
}

TEST(InputFormat, HashIsOfTheBytes) {
  const std::string text = "1 2 3\n";
  EXPECT_EQ(read_bytes("a.xyz", text).hash.size(), 32u);
  EXPECT_EQ(read_bytes("a.xyz", text).hash, read_bytes("b.xyz", text).hash);
  EXPECT_NE(read_bytes("a.xyz", text).hash, read_bytes("a.xyz", "1 2 4\n").hash);
}

}  // namespace
}  // namespace geodrome::testing
