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

/// `mark` stands before and after each ending.
std::string read_text(const Format& format, std::string_view remark, const std::string& mark) {
  std::string inside;
  for (const std::string_view ending : format.endings) append_word(inside, mark + std::string(ending) + mark);
  if (!inside.empty() && !remark.empty()) inside += ": ";
  inside += remark;
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

}  // namespace

std::string help_for_reading(Content content) { return all_read(content, ""); }

std::string help_for_writing(Content content) { return all_written(content, ""); }

std::string help_for_input() {
  std::string meshes, points;
  for (const Format& format : formats()) {
    if (!format.read) continue;
    append_word(format.reads(Content::mesh) ? meshes : points, std::string(format.name));
  }
  return meshes + " (meshes or points) or " + points + " (points)";
}

std::string table_of_formats() {
  std::string table = "| | read | written, by the ending of the name |\n|---|---|---|\n";
  for (const Row& row : table_rows)
    table += std::string("| ") + row.title + " | " + all_read(row.content, "`") + " | " +
             all_written(row.content, "`") + " |\n";
  return table;
}

}  // namespace geodrome
