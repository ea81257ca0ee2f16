// SPDX-License-Identifier: MIT
#include "engine/formats/table.hpp"
#include "engine/formats/text.hpp"

// The table of formats as text.
namespace geodrome {

namespace {

struct Row {
  Content content;
  const char* title;
};

constexpr Row table_rows[] = {{Content::mesh, "meshes"},
                              {Content::points, "points"},
                              {Content::weights, "weights of faces"},
                              {Content::matrix, "matrices"},
                              {Content::nearest, "nearest sources"},
                              {Content::pairs, "pairs"},
                              {Content::path, "paths"},
                              {Content::report, "reports"},
                              {Content::figures, "figures of comparisons"},
                              {Content::page, "pages of comparisons"},
                              {Content::pair_index, "indices of pair oracles"}};

/// Returns the endings and the remark; `mark` stands before and after each ending.
std::string endings_and_remark(const Format& format, std::string_view remark, const std::string& mark) {
  std::string text;
  for (const std::string_view ending : format.endings) append_word(text, mark + std::string(ending) + mark);
  if (!text.empty() && !remark.empty()) text += ": ";
  return text += remark;
}

std::string read_text(const Format& format, std::string_view remark, const std::string& mark) {
  const std::string inside = endings_and_remark(format, remark, mark);
  return std::string(format.name) + (inside.empty() ? "" : " (" + inside + ")");
}

std::string written_text(const Format& format, std::string_view remark, const std::string& mark) {
  if (format.endings.empty()) return std::string(remark);
  const std::string ending = mark + std::string(format.endings.front()) + mark;
  return remark.empty() ? ending : ending + " (" + std::string(remark) + ")";
}

std::string all_read(Content content, const std::string& mark) {
  std::string list;
  for (const Format& format : formats())
    if (format.reads(content)) append_word(list, read_text(format, *format.use(content)->read, mark));
  return list;
}

std::string all_written(Content content, const std::string& mark) {
  std::string list;
  for (const Format& format : formats())
    if (format.writes(content)) append_word(list, written_text(format, *format.use(content)->written, mark));
  return list;
}

/// Returns the row of a format that holds such content.
std::string row_of(const Row& row, const Format& format) {
  const auto& use = *format.use(row.content);
  const std::string read = use.read ? endings_and_remark(format, *use.read, "`") : "";
  const std::string written = use.written ? written_text(format, *use.written, "`") : "";
  return std::string("| ") + row.title + " | " + std::string(format.name) + " | " + read + " | " + written + " |\n";
}

}  // namespace

std::string help_for_reading(Content content) { return all_read(content, ""); }

std::string help_for_writing(Content content) { return all_written(content, ""); }

std::string help_for_input() {
  std::string meshes, points;
  for (const Format& format : formats()) {
    if (!format.read) continue;
    append_word(format.reads(Content::mesh) ? meshes : points, std::string(format.name));
  }
  return meshes + " (meshes or points) or " + points + " (points); any of them gzip-compressed or not";
}

std::string table_of_formats() {
  std::string table = "| content | format | read | written |\n|---|---|---|---|\n";
  for (const Row& row : table_rows)
    for (const Format& format : formats())
      if (format.use(row.content)) table += row_of(row, format);
  return table;
}

}  // namespace geodrome
