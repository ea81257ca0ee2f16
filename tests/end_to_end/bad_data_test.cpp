// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

const std::filesystem::path bad_folder = std::filesystem::path(GEODROME_SHARED_DATA) / "bad";

struct Expected {
  std::string file, verdict, error;
  std::size_t vertices = 0, faces = 0;

  friend void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }
};

std::vector<Expected> read_expected() {
  std::ifstream stream(bad_folder / "expected.json");
  if (!stream) return {};
  std::vector<Expected> all;
  for (const auto& entry : nlohmann::json::parse(stream)) {
    Expected expected{entry["file"], entry["verdict"], entry["error"]};
    if (!entry["vertices"].is_null()) expected.vertices = entry["vertices"];
    if (!entry["faces"].is_null()) expected.faces = entry["faces"];
    all.push_back(expected);
  }
  return all;
}

std::string test_name(const ::testing::TestParamInfo<Expected>& info) {
  std::string name = info.param.file;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

class BadData : public ::testing::TestWithParam<Expected> {};

TEST_P(BadData, GetsItsVerdict) {
  const Expected& expected = GetParam();
  std::optional<Input> input;
  const auto error = error_of([&] { input = read_input(bad_folder / expected.file); });
  if (error) {
    EXPECT_NE(expected.verdict.find("reject"), std::string::npos) << error->what();
    EXPECT_EQ(name(error->fault()), expected.error) << error->what();
    EXPECT_NE(std::string(error->what()).find(expected.file), std::string::npos) << error->what();
    return;
  }
  // An OFF file under a wrong name is read by its content, and so is a compressed one.
  EXPECT_TRUE(expected.verdict != "reject" || expected.file == "wrong_extension.ply" || expected.file == "gzipped.ply");
  expect_valid(*input);
  if (expected.vertices > 0) {
    EXPECT_EQ(input->facts.rows, expected.vertices);
    EXPECT_EQ(input->facts.faces_in_file, expected.faces);
  }
  if (expected.verdict == "accept") {
    EXPECT_FALSE(has_warning(*input));
  }
  if (expected.verdict == "accept, warn") {
    EXPECT_TRUE(has_warning(*input));
  }
}

INSTANTIATE_TEST_SUITE_P(Files, BadData, ::testing::ValuesIn(read_expected()), test_name);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(BadData);

class BadDataDetails : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(bad_folder)) GTEST_SKIP() << "no folder " << bad_folder;
  }
  static Input read(const char* name, const ReadOptions& options = {}) {
    return read_input(bad_folder / name, options);
  }
};

TEST_F(BadDataDetails, MessagesNameTheElement) {
  const std::pair<const char*, const char*> parts[] = {{"bad_number.off", "line 5"},
                                                       {"ragged.xyz", "line 3"},
                                                       {"index_out_of_range.off", "face 7 names vertex 6"},
                                                       {"index_negative.off", "vertex -1"},
                                                       {"index_out_of_range.ply", "2147483647"},
                                                       {"nan_coordinate.ply", "vertex 5"},
                                                       {"inf_coordinate.off", "vertex 5"},
                                                       {"nan_points.xyz", "read.drop_nonfinite"},
                                                       {"header_4e9_vertices.ply", "4000000000"},
                                                       {"header_4e9_vertices_ascii.ply", "4000000000"}};
  for (const auto& [file, part] : parts) {
    const auto error = error_of([&, name = file] { read(name); });
    ASSERT_TRUE(error) << file;
    EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << error->what();
  }
}

TEST_F(BadDataDetails, AllSoundOctahedraAreTheSameMesh) {
  const Input first = read("big_endian.ply");
  EXPECT_DOUBLE_EQ(distance(first.positions[0], first.positions[2]), std::sqrt(2.0));
  for (const char* name : {"crlf.obj", "crlf_ascii.ply", "comments_whitespace.off", "negative_ok.obj",
                           "wrong_extension.ply", "gzipped.ply"}) {
    const Input other = read(name);
    EXPECT_EQ(other.positions, first.positions) << name;
    EXPECT_EQ(other.triangles, first.triangles) << name;
  }
}

TEST_F(BadDataDetails, LargeOffsetsKeepTheirDoubles) {
  const Input input = read("large_offset.ply");
  EXPECT_NEAR(distance(input.positions[0], input.positions[2]), std::sqrt(2.0), 1e-7);
}

TEST_F(BadDataDetails, NonfinitePointsAreDroppedAndCountedOnDemand) {
  const Input input = read("nan_points.xyz", {.drop_nonfinite = true});
  expect_valid(input);
  EXPECT_EQ(input.positions.size(), 16u);
  EXPECT_EQ(input.facts.dropped, 2u);
  EXPECT_EQ(input.element_of_row[17], no_index);
  EXPECT_TRUE(has_finding(input, "dropped_nonfinite"));
}

TEST_F(BadDataDetails, AMeshWithoutFacesIsRefusedAsMesh) {
  expect_refused([] { read("vertices_only.off", {.as = InputKind::mesh}); }, InputFault::empty, "no faces");
}

TEST_F(BadDataDetails, DegenerateFacesAreDroppedAndCounted) {
  for (const auto& [file, dropped] : {std::pair{"repeated_index.off", 2u}, {"polygon_2gon.off", 1u}}) {
    const Input input = read(file);
    EXPECT_EQ(input.triangles.size(), 8u) << file;
    EXPECT_EQ(input.facts.degenerate_faces_dropped, dropped) << file;
    EXPECT_TRUE(has_finding(input, "degenerate_faces")) << file;
  }
}

TEST_F(BadDataDetails, DefectsAreCounted) {
  EXPECT_EQ(read("nonmanifold_edge.off").facts.nonmanifold_edges, 1u);
  EXPECT_EQ(read("nonmanifold_vertex.obj").facts.nonmanifold_vertices, 1u);
  EXPECT_EQ(read("duplicate_faces.off").facts.duplicate_faces, 3u);
  EXPECT_EQ(read("duplicate_vertices.off").facts.components, 8u);
  EXPECT_EQ(read("zero_area_collinear.off").facts.zero_area_faces, 1u);
  EXPECT_EQ(read("isolated_vertices.ply").facts.isolated_vertices, 2u);
  EXPECT_EQ(read("two_components.obj").facts.components, 2u);
  EXPECT_EQ(read("polygons.off").triangles.size(), 16u);
}

TEST_F(BadDataDetails, TheMoebiusStripHasOneLoopAndNoOrientation) {
  const InputFacts facts = read("moebius.off").facts;
  EXPECT_TRUE(facts.manifold);
  EXPECT_FALSE(facts.orientable);
  EXPECT_EQ(facts.boundary_loops, 1u);
  EXPECT_EQ(facts.euler_number, 0);
  EXPECT_FALSE(facts.genus);
}

TEST_F(BadDataDetails, ASoupWeldsToTheOctahedron) {
  const InputFacts facts = read("duplicate_vertices.off", {.weld = true}).facts;
  EXPECT_EQ(facts.merged, 18u);
  EXPECT_EQ(facts.components, 1u);
  EXPECT_EQ(facts.boundary_edges, 0u);
  EXPECT_EQ(facts.genus, 0);
}

}  // namespace
}  // namespace geodrome::testing
