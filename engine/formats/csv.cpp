// SPDX-License-Identifier: MIT
#include "engine/formats/csv.hpp"

#include <charconv>
#include <cmath>

#include "engine/formats/columns/point_table.hpp"
#include "engine/formats/npy.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/formats/table.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

void append_csv_row(std::string& text, std::span<const double> values, ScalarType scalar) {
  char number[csv_bytes_per_entry];
  const char* separator = "";
  for (const double value : values) {
    text += separator;
    separator = ",";
    if (std::isnan(value)) {  // to_chars would show the sign of a NaN, which means nothing
      text += "nan";
      continue;
    }
    const auto [end, error] = scalar == ScalarType::float64
                                  ? std::to_chars(number, std::end(number), value)
                                  : std::to_chars(number, std::end(number), static_cast<float>(value));
    text.append(number, end);
  }
  text += '\n';
}

namespace {

std::string csv_path(const PathResult& path) {
  std::string text = "x,y,z,face,b0,b1,b2\n";
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const Vec3& p = path.positions[i];
    const SurfacePoint& at = path.points[i];
    text += number_text(p.x) + "," + number_text(p.y) + "," + number_text(p.z) + "," + std::to_string(at.face);
    for (const double b : at.b) text += "," + number_text(b);
    text += "\n";
  }
  return text;
}

}  // namespace

Format csv_format() {
  static constexpr TextFormat text{append_csv_row, csv_bytes_per_entry, 1'000'000};
  static constexpr MatrixFormat matrix{.dense = npy_dense, .text = &text};
  return {.name = "CSV",
          .endings = {".csv"},
          .uses = {{.content = Content::points, .read = "a point a line, in columns"},
                   {.content = Content::matrix, .written = "up to 1e6 entries"},
                   {.content = Content::nearest, .written = "target, distance, source, reach"},
                   {.content = Content::pairs, .written = "pair, from, to, distance, reach"},
                   {.content = Content::path, .written = "x, y, z, face, b0, b1, b2"}},
          .read = [](const input::SourceFile& file) { return input::read_point_table(file, {}); },
          .read_columns = input::read_point_table,
          .write_path = csv_path,
          .matrix = &matrix};
}

}  // namespace geodrome
