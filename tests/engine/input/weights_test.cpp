// SPDX-License-Identifier: MIT
#include <sstream>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

const TemporaryFolder& folder() {
  static const TemporaryFolder made;
  return made;
}

/// Options that name a file with this text.
ReadOptions weights_in_file(const std::string& text) {
  const std::filesystem::path file = folder() / "w.txt";
  std::ofstream(file, std::ios::binary) << text;
  return {.weights = file.string()};
}

/// A quad that is split, a face that is dropped, a triangle.
const std::string three_faces = "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 1 2\n3 1 4 2\n";

std::string ply(const std::string& values, const std::string& type = "double", const std::string& name = "cost") {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty " +
      type + " " + name + "\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  std::istringstream each(values);
  std::string value;
  for (const char* face : {"3 0 1 2", "3 0 2 3"}) each >> value, text += face + (" " + value) + "\n";
  return text;
}

void expect_refused_weights(const std::string& text, InputFault fault, const std::string& part) {
  expect_refused([&] { read_bytes("m.off", three_faces, weights_in_file(text)); }, fault, part);
}

TEST(InputWeights, AreThoseOfTheFacesThatTrianglesComeFrom) {
  const Input input = read_bytes("m.off", three_faces, weights_in_file("# cost\n2\n\n7\n0.5\n"));
  EXPECT_EQ(input.face_of_triangle, (std::vector<Index>{0, 0, 2}));
  EXPECT_EQ(input.weights, (std::vector<double>{2, 2, 0.5}));
}

TEST(InputWeights, AreReadFromAPropertyOfPly) {
  const Input input = read_bytes("m.ply", ply("3 0.25"), {.weights = "property:cost"});
  EXPECT_EQ(input.weights, (std::vector<double>{3, 0.25}));
  EXPECT_EQ(input.weights_from, "property:cost");
}

TEST(InputWeights, AreReadFromIntegersOfPlyToo) {
  EXPECT_EQ(read_bytes("m.ply", ply("3 2", "uchar"), {.weights = "property:cost"}).weights,
            (std::vector<double>{3, 2}));
}

TEST(InputWeights, AreNoneIfNotAskedFor) {
  const Input input = read_bytes("m.ply", ply("3 2"));
  EXPECT_TRUE(input.weights.empty());
  EXPECT_TRUE(input.weights_hash.empty());
}

TEST(InputWeights, AreToldOfIfTheyLookLikeThemAndAreNotUsed) {
  EXPECT_TRUE(has_finding(read_bytes("m.ply", ply("3 2", "float", "Weight")), "weights_not_used"));
  EXPECT_FALSE(has_finding(read_bytes("m.ply", ply("3 2", "float", "quality")), "weights_not_used"));
  EXPECT_FALSE(has_finding(read_bytes("m.ply", ply("3 2", "float", "weight"), {.weights = "property:weight"}),
                           "weights_not_used"));
}

TEST(InputWeights, HaveAHashOfTheirNumbers) {
  const auto hash = [](const std::string& text) {
    return read_bytes("m.off", three_faces, weights_in_file(text)).weights_hash;
  };
  EXPECT_EQ(hash("2\n7\n0.5\n"), hash("2.0\n7\n5e-1"));
  EXPECT_NE(hash("2\n7\n0.5\n"), hash("2\n7\n0.25\n"));
}

TEST(InputWeights, SurviveWriting) {
  const SurfaceMesh mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, {1.0 / 3, 7});
  write_mesh(folder() / "out.ply", mesh);
  const Input input = read_input(folder() / "out.ply", {.weights = "property:weight"});
  EXPECT_EQ(input.weights, (std::vector<double>{1.0 / 3, 7}));
  EXPECT_THROW(write_mesh(folder() / "out.off", mesh), OptionError);
}

TEST(InputWeights, OfAnotherNumberThanTheFacesAreRefused) {
  expect_refused_weights("1\n2\n", InputFault::index, "holds 2 weights");
  expect_refused_weights("1\n2\n3\n4\n", InputFault::index, "has 3 faces");
}

TEST(InputWeights, ThatAreNoWeightsAreRefusedWithTheirLine) {
  expect_refused_weights("1\n\n0\n3\n", InputFault::range, "line 3: the weight 0 is not positive");
  expect_refused_weights("1\n-2\n3\n", InputFault::range, "of face 1");
  expect_refused_weights("1\n2\nnan\n", InputFault::nonfinite, "line 3");
  expect_refused_weights("inf\n2\n3\n", InputFault::nonfinite, "line 1");
  expect_refused_weights("1\n2\nx\n", InputFault::syntax, "'x' is no number");
  expect_refused_weights("1\n1e200\n3\n", InputFault::range, "1e100");
  expect_refused_weights("1 2 3\n", InputFault::syntax, "more than one weight");
  expect_refused_weights("1\n0\n3\n", InputFault::range, "w.txt");  // of the face that is dropped
}

TEST(InputWeights, OfAPropertyThatAreNoneAreRefusedWithTheirFace) {
  const ReadOptions options{.weights = "property:cost"};
  expect_refused([&] { read_bytes("m.ply", ply("1 0"), options); }, InputFault::range, "face 1");
  expect_refused([&] { read_bytes("m.ply", ply("nan 1"), options); }, InputFault::nonfinite, "face 0");
  expect_refused([&] { read_bytes("m.ply", ply("1 -3", "int"), options); }, InputFault::range, "-3");
  expect_refused([&] { read_bytes("m.ply", ply("1 x"), options); }, InputFault::syntax, "'x' is no number");
}

TEST(InputWeights, OfAPropertyThatIsNotThereAreRefusedWithThoseThatAre) {
  const ReadOptions options{.weights = "property:price"};
  expect_refused([&] { read_bytes("m.ply", ply("1 2"), options); }, InputFault::unsupported, "'cost'");
  expect_refused([&] { read_bytes("m.off", three_faces, options); }, InputFault::unsupported, "only faces of PLY");
  expect_refused([] { read_bytes("m.ply", ply("1 2"), {.weights = "property:vertex_indices"}); },
                 InputFault::unsupported, "vertex_indices");
}

TEST(InputWeights, OfPointsAreRefused) {
  expect_refused([] { read_bytes("p.xyz", "0 0 0\n1 0 0\n", weights_in_file("1\n")); }, InputFault::unsupported,
                 "points");
  ReadOptions options = weights_in_file("1\n2\n3\n");
  options.as = InputKind::points;
  expect_refused([&] { read_bytes("m.off", three_faces, options); }, InputFault::unsupported, "points");
}

TEST(InputWeights, ThatNameNothingAreRefused) {
  EXPECT_THROW(read_bytes("m.ply", ply("1 2"), {.weights = "property:"}), OptionError);
  expect_refused([] { read_bytes("m.off", three_faces, {.weights = "/no/such/file"}); }, InputFault::io, "no such");
}

}  // namespace
}  // namespace geodrome::testing
