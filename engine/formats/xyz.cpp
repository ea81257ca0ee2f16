// SPDX-License-Identifier: MIT
#include "engine/formats/columns/point_table.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text_output.hpp"

// One point a line. It is read by point_table.cpp.
namespace geodrome {
namespace {

std::string xyz_text(const MeshToWrite& points) {
  std::string text;
  for (const Vec3& p : points.positions) append_point(text, "", p);
  return text;
}

}  // namespace

Format xyz_format() {
  return {.name = "XYZ",
          .endings = {".xyz", ".pts", ".asc", ".txt"},
          .uses = {{Content::points, "a point a line, in columns", ""}},
          .read = [](const input::SourceFile& file) { return input::read_point_table(file, {}); },
          .read_columns = input::read_point_table,
          .write = xyz_text};
}

}  // namespace geodrome
