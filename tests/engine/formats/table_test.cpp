// SPDX-License-Identifier: MIT
#include "engine/formats/table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "engine/formats/ending.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "tests/support/input_files.hpp"

namespace geodrome::testing {
namespace {

std::string_view chosen(const char* file, Content content) { return format_to_write(file, content).name; }

std::string error_of_ending(const char* file, Content content) {
  try {
    format_to_write(file, content);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Formats, AreChosenByTheEndingInAnyCase) {
  EXPECT_EQ(chosen("T.PLY", Content::mesh), "PLY");
  EXPECT_EQ(chosen("folder.x/t.Obj", Content::mesh), "OBJ");
  EXPECT_EQ(chosen("D.NPY", Content::matrix), "NPY");
  EXPECT_EQ(chosen("d.Csv", Content::nearest), "CSV");
  EXPECT_EQ(chosen("p.JSON", Content::path), "JSON");
}

TEST(Formats, AreRefusedWhereTheyAreNotWritten) {
  EXPECT_EQ(error_of_ending("m.xyz", Content::mesh), "m.xyz: the name must end in .ply, .off, .obj, .stl");
  EXPECT_EQ(error_of_ending("d.ply", Content::matrix), "d.ply: the name must end in .npy, .csv");
  EXPECT_EQ(error_of_ending("p.pts", Content::points), "p.pts: the name must end in .xyz, .ply, .off");
  EXPECT_EQ(error_of_ending("npy", Content::matrix), "npy: the name must end in .npy, .csv");
  EXPECT_EQ(error_of_ending(".npy", Content::matrix), ".npy: the name must end in .npy, .csv");
}

TEST(Formats, OfAMeshWithWeightsMustHoldThem) {
  EXPECT_EQ(mesh_format_to_write("m.PLY", true).name, "PLY");
  EXPECT_EQ(mesh_format_to_write("m.off", false).name, "OFF");
  EXPECT_THROW(mesh_format_to_write("m.off", true), OptionError);
}

TEST(Formats, OfOutputsAreCheckedBeforeTheWork) {
  EXPECT_NO_THROW(check_ending("D.NPY", Content::matrix));
  EXPECT_NO_THROW(check_ending("", Content::matrix));
  EXPECT_THROW(check_ending("d.h5", Content::matrix), OptionError);
  EXPECT_NO_THROW(check_mesh_ending("T.PLY", {.weights = "w.txt"}));
  EXPECT_THROW(check_mesh_ending("t.stl", {.weights = "w.txt"}), OptionError);
}

TEST(Formats, HaveTheFunctionsThatTheirUsesNeed) {
  for (const Format& format : formats()) {
    SCOPED_TRACE(format.name);
    const bool reads = format.reads(Content::mesh) || format.reads(Content::points);
    const bool writes = format.writes(Content::mesh) || format.writes(Content::points);
    EXPECT_EQ(reads, format.read != nullptr);
    EXPECT_EQ(writes, format.write != nullptr);
    EXPECT_EQ(format.writes(Content::path), format.write_path != nullptr);
    EXPECT_EQ(format.writes(Content::matrix), format.matrix != nullptr);
    for (const std::string_view ending : format.endings) EXPECT_EQ(ending, lower_case(ending));
  }
}

TEST(Formats, ShareNoEnding) {
  std::set<std::string_view> all;
  for (const Format& format : formats())
    for (const std::string_view ending : format.endings) EXPECT_TRUE(all.insert(ending).second) << ending;
}

TEST(Formats, ReadWhatTheyWrite) {
  const SurfaceMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}});
  const TemporaryFolder folder;
  for (const Format& format : formats()) {
    SCOPED_TRACE(format.name);
    for (const Content content : {Content::mesh, Content::points}) {
      if (!format.reads(content) || !format.writes(content)) continue;
      const auto file = folder / ("written" + std::string(format.endings.front()));
      const std::vector<Vec3> points(mesh.positions().begin(), mesh.positions().end());
      content == Content::mesh ? write_mesh(file, mesh) : write_points(file, points);
      const Input input = read_input(file);
      EXPECT_EQ(input.format, lower_case(format.name));
      EXPECT_EQ(input.kind == InputKind::mesh, content == Content::mesh);
      EXPECT_EQ(input.positions, points);
    }
  }
}

TEST(Endings, MayHaveSeveralDots) {
  EXPECT_TRUE(has_ending("lh.SURF.gii", ".surf.gii"));
  EXPECT_FALSE(has_ending("surf.gii", ".surf.gii"));
  EXPECT_FALSE(has_ending("folder.npy/d", ".npy"));
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(HelpTexts, NameFormatsAndEndings) {
  EXPECT_EQ(help_for_input(),
            "PLY, OFF, OBJ, STL (meshes or points) or XYZ, CSV (points); any of them gzip-compressed or not");
  EXPECT_EQ(help_for_writing(Content::mesh), ".ply (binary, double), .off, .obj, .stl (binary, float)");
  EXPECT_EQ(help_for_reading(Content::matrix), "NPY (.npy: float64 or float32 in C order, to compare with)");
  EXPECT_EQ(help_for_reading(Content::path), "");
}

TEST(HelpTexts, StandInTheManual) {
  const std::string manual = bytes_of(GEODROME_SOURCE_DIR "/tools/geodrome/README.md");
  EXPECT_NE(manual.find(table_of_formats()), std::string::npos)
      << "the table of formats in tools/geodrome/README.md must be:\n"
      << table_of_formats();
}

}  // namespace
}  // namespace geodrome::testing
