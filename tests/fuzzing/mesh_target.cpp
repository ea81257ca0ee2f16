// SPDX-License-Identifier: MIT
// Files of meshes and points: each format alone, and all by the choice that content and name make. The first byte:
// 1 weld and drop what is not finite; 2, 4 as a mesh or as points; 8 weights; 16 and 32 the law that is tried: none,
// line ends, the encodings of PLY, a round trip; 64, 128 its format.
#include <algorithm>

#include "engine/formats/ending.hpp"
#include "engine/formats/table.hpp"
#include "engine/input/check_soup.hpp"
#include "engine/input/merge.hpp"
#include "tests/fuzzing/mesh_promises.hpp"
#include "tests/fuzzing/mesh_seeds.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

using input::Soup;
using input::SourceFile;

constexpr const char* weight_property = "weight";

const Format& format_called(std::string_view name) {
  for (const Format& format : formats())
    if (format.name == name) return format;
  throw std::invalid_argument("no such format");
}

SourceFile file_of(const Format& format, std::string_view bytes) {
  return {"m" + std::string(format.endings.front()), std::string(bytes)};
}

/// Of a format, or of whatever the content tells where `format` is null.
Soup read(const Format* format, const SourceFile& file, bool weighted) {
  if (!format) return input::parse(file, {weighted ? weight_property : ""});
  return weighted && format->read_weighted ? format->read_weighted(file, weight_property) : format->read(file);
}

/// What is read does not depend on how lines end, nor on an empty line at the end.
void demand_same_with_other_line_ends(const Format* format, const SourceFile& file, const Soup& soup) {
  const std::string& bytes = file.bytes;
  if (bytes.find_first_of(std::string_view("\0\r", 2)) != bytes.npos || bytes.find("binary") != bytes.npos) return;
  const auto reads_the_same = [&](std::string text) {
    return same(read(format, {file.path, std::move(text)}, false), soup);
  };
  demand(reads_the_same(with_windows_line_ends(bytes)), "line ends of Windows change nothing");
  demand(reads_the_same(bytes + "\n"), "an empty line at the end changes nothing");
}

/// Text and both byte orders of PLY hold the same.
void demand_same_as_ply(const Soup& soup) {
  for (const PlyText encoding : {PlyText::ascii, PlyText::little_endian, PlyText::big_endian})
    demand(same(format_called("PLY").read({"m.ply", ply_of(soup, encoding)}), soup), "PLY holds what was read");
}

void demand_same_without_weights(const Format* format, const SourceFile& file, Soup soup) {
  soup.face_weights.clear();
  demand(same(read(format, file, false), soup), "weights change nothing else");
}

Input checked(const SourceFile& file, const ReadOptions& options, Soup soup) {
  if (soup.vertices_by_place) input::merge_vertices(soup);
  return input::check_soup(input::Origin(file.path), options, std::move(soup), "");
}

/// Written and read again it is the same; as floats, where the format holds these, the count of faces is.
void demand_round_trip(const Format& writer, const Input& input) {
  const bool weighted = !input.weights.empty(), is_mesh = input.kind == InputKind::mesh;
  if (!writer.writes(is_mesh ? Content::mesh : Content::points) || (weighted && !writer.read_weighted)) return;
  const SourceFile file = file_of(writer, "");
  const auto bytes = read_or_refusal(file.path.string(), "", [&] {
    return writer.write({file.path, input.positions, input.triangles, input.weights});
  });
  if (!bytes) return;
  const SourceFile written = file_of(writer, *bytes);
  const Soup soup = read(&writer, written, weighted);
  if (soup.vertices_by_place) {
    demand(soup.face_count() == input.triangles.size(), "every face comes back");
    return;
  }
  const ReadOptions options{.as = input.kind, .weights = weighted ? "property:weight" : ""};
  demand_same_mesh(checked(written, options, soup), input);
}

const Format& writer_of(unsigned choice) {
  static const Format* const writers[] = {&format_called("OFF"), &format_called("PLY"), &format_called("OBJ"),
                                          &format_called("STL")};
  return *writers[choice];
}

void check_file(const Format* format, const SourceFile& file, const Choices& choices) {
  const std::string name = file.path.string();
  const bool weighted = choices.bit(3) && (!format || format->read_weighted);
  const auto soup = read_or_refusal(name, file.bytes, [&] { return read(format, file, weighted); });
  if (!soup) return;
  demand_sound(*soup, file.bytes.size());
  if (!weighted && choices.bits(4, 2) == 1) demand_same_with_other_line_ends(format, file, *soup);
  if (!weighted && choices.bits(4, 2) == 2) demand_same_as_ply(*soup);
  if (weighted) demand_same_without_weights(format, file, *soup);

  ReadOptions options{.weld = choices.bit(0), .drop_nonfinite = choices.bit(0)};
  if (weighted) options.weights = std::string("property:") + weight_property;
  if (choices.bits(1, 2) == 1) options.as = InputKind::mesh;
  if (choices.bits(1, 2) == 2) options.as = InputKind::points;
  const auto input = read_or_refusal(name, file.bytes, [&] { return checked(file, options, *soup); });
  if (!input) return;
  demand_sound(*input);
  if (choices.bits(4, 2) != 3) return;
  const bool points = input->kind == InputKind::points;
  demand_round_trip(points ? format_called("XYZ") : writer_of(choices.bits(6, 2)), *input);
}

void check_format(std::string_view name, std::string_view input) {
  const Format& format = format_called(name);
  check_file(&format, file_of(format, rest_of(input)), Choices(input));
}

}  // namespace

void check_off(std::string_view input) { check_format("OFF", input); }
void check_obj(std::string_view input) { check_format("OBJ", input); }
void check_ply(std::string_view input) { check_format("PLY", input); }
void check_stl(std::string_view input) { check_format("STL", input); }
void check_xyz(std::string_view input) { check_format("XYZ", input); }
void check_csv(std::string_view input) { check_format("CSV", input); }

/// Any file, under a name that may or may not tell its format.
void check_any(std::string_view input) {
  constexpr std::string_view names[] = {"m.ply", "m.stl", "m.pts", "m"};
  const Choices choices(input);
  check_file(nullptr, {names[choices.bits(6, 2)], std::string(rest_of(input))}, choices);
}

}  // namespace geodrome::fuzzing
