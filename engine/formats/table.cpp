// SPDX-License-Identifier: MIT
#include "engine/formats/table.hpp"

#include <algorithm>

#include "engine/formats/ending.hpp"
#include "engine/formats/text.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

// Each stands beside its readers and writers.
Format xyz_format();
Format ply_format();
Format off_format();
Format obj_format();
Format stl_format();
Format npy_format();
Format csv_format();
Format json_format();

namespace {

// Formats that are read or written where they are used, and nowhere else.
Format text_format() {
  return {.name = "text",
          .uses = {{Content::weights, "a number a line for each face"},
                   {Content::pairs, "two points a line, separated by a comma"}}};
}

Format html_format() {
  return {.name = "HTML", .endings = {".html"}, .uses = {{.content = Content::page, .written = ""}}};
}

Format index_format() {
  return {
      .name = "index",
      .uses = {{Content::pair_index, "any name; as it was written, by a machine of the same byte order", "any name"}}};
}

}  // namespace

std::span<const Format> formats() {
  static const std::vector<Format> all = {xyz_format(),  ply_format(),  off_format(),  obj_format(),
                                          stl_format(),  text_format(), npy_format(),  csv_format(),
                                          json_format(), html_format(), index_format()};
  return all;
}

const Use* Format::use(Content content) const {
  const auto found = std::ranges::find(uses, content, &Use::content);
  return found == uses.end() ? nullptr : &*found;
}

bool Format::reads(Content content) const {
  const Use* found = use(content);
  return found && found->read;
}

bool Format::writes(Content content) const {
  const Use* found = use(content);
  return found && found->written;
}

const Format& format_to_write(const std::filesystem::path& file, Content content) {
  const Format* best = nullptr;
  std::string valid;
  for (const Format& format : formats()) {
    if (!format.writes(content) || format.endings.empty()) continue;
    const std::string_view ending = format.endings.front();
    append_word(valid, std::string(ending));
    if (has_ending(file, ending) && (!best || ending.size() > best->endings.front().size())) best = &format;
  }
  if (!best) throw OptionError(file.string() + ": the name must end in " + valid);
  return *best;
}

const Format& mesh_format_to_write(const std::filesystem::path& file, bool weighted, ScalarType scalar) {
  const Format& format = format_to_write(file, Content::mesh);
  if (weighted && !format.writes(Content::weights))
    throw OptionError(file.string() + ": only PLY holds the weights of the faces", "write .ply");
  if (scalar == ScalarType::float32 && format.mesh_numbers == MeshNumbers::float64)
    throw OptionError(file.string() + ": its numbers are text, which needs no float32", "write .ply or .stl");
  return format;
}

}  // namespace geodrome
