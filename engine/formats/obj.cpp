// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <string_view>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text.hpp"
#include "engine/formats/text_output.hpp"
#include "geodrome/engine/jobs.hpp"

// Wavefront OBJ: the records v and f. All other records are passed over; those that hold geometry are told.
namespace geodrome {
namespace {

using namespace input;

constexpr long long first_index = 1;  // OBJ counts from 1

// "7", "7/2", "7//3", "7/2/3": the vertex, counted from 0. Negative numbers count back from the latest vertex.
long long vertex_of_corner(const LineReader& lines, std::string_view word, std::size_t vertices_so_far) {
  const std::string_view digits = word.substr(0, word.find('/'));
  const char* const end = digits.data() + digits.size();
  long long value = 0;
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stop != end) lines.reject(InputFault::syntax, quoted(word) + " is no corner of a face");
  if (value == 0) lines.reject(InputFault::index, "a face names vertex 0, but OBJ counts from 1");
  return value > 0 ? value - first_index : static_cast<long long>(vertices_so_far) + value;
}

void read_face(const SourceFile& file, LineReader& lines, Soup& soup) {
  for (std::string_view word = lines.word(); !word.empty(); word = lines.word()) {
    const long long vertex = vertex_of_corner(lines, word, soup.positions.size());
    // A face may stand before its vertices: how many there are is known at the end only.
    if (vertex < 0 || vertex >= no_index)
      checked_corner(file, soup.face_count(), vertex, soup.positions.size(), first_index);
    soup.corners.push_back(static_cast<Index>(vertex));
  }
  soup.face_end.push_back(soup.corners.size());
}

void check_corners(const SourceFile& file, const Soup& soup) {
  for (std::size_t f = 0; f < soup.face_count(); ++f)
    for (const Index vertex : soup.face(f)) checked_corner(file, f, vertex, soup.positions.size(), first_index);
}

bool is_record_name(std::string_view word) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto rest = [&](char c) { return letter(c) || c == '_' || (c >= '0' && c <= '9'); };
  return letter(word[0]) && std::all_of(word.begin(), word.end(), rest);
}

bool is_one_of(std::string_view record, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), record) != names.end();
}

/// `fo` is how the first versions of the format wrote `f`.
bool is_face(std::string_view record) { return record == "f" || record == "fo"; }

bool holds_geometry(std::string_view record) { return is_one_of(record, {"l", "p", "curv", "curv2", "surf"}); }

/// Records of OBJ that hold no vertex and no face: attributes, groups, materials, what belongs to curves and surfaces.
bool holds_none(std::string_view record) {
  return is_one_of(
      record, {"vt",     "vn",    "vp",       "g",        "s",    "o",     "mg",    "mtllib", "usemtl",     "maplib",
               "usemap", "bevel", "c_interp", "d_interp", "lod",  "ctech", "stech", "cstype", "deg",        "bmat",
               "step",   "parm",  "trim",     "hole",     "scrv", "sp",    "end",   "con",    "shadow_obj", "trace_obj",
               "call",   "csh",   "bsp",      "bzp",      "cdc",  "cdp",   "res"});
}

/// A backslash at the end of a line should join the next one, but one that begins with v or f is a record of its own.
class UnjoinedLines {
 public:
  void see(const LineReader& lines, std::string_view record) {
    if (open_ != 0 && (record == "v" || is_face(record)) && count_++ == 0) first_ = open_;
    open_ = lines.ends_in_backslash() ? lines.line() : 0;
  }
  void tell(Soup& soup) const {
    if (count_ == 0) return;
    soup.findings.push_back({Finding::Severity::warning,
                             "backslash_joins_nothing",
                             counted(count_, "line ends", "lines end") +
                                 " in a backslash before a record v or f, the " + "first is line " +
                                 std::to_string(first_) + "; the record was read by itself.",
                             count_,
                             {}});
  }

 private:
  std::size_t open_ = 0;  // the line before, if it ends in a backslash
  std::size_t count_ = 0, first_ = 0;
};

/// Records that might be vertices or faces for some other program.
class UnknownRecords {
 public:
  void see(const LineReader& lines, std::string_view record) {
    if (count_++ == 0) first_ = quoted(record) + " in line " + std::to_string(lines.line());
  }
  void tell(Soup& soup) const {
    if (count_ == 0) return;
    soup.findings.push_back({Finding::Severity::warning,
                             "unknown_records",
                             counted(count_, "line", "lines") +
                                 " of the OBJ file hold no record of the format, the first " + first_ +
                                 "; they were not used.",
                             count_,
                             {}});
  }

 private:
  std::size_t count_ = 0;
  std::string first_;
};

Soup read_obj(const SourceFile& file) {
  Soup soup;
  Finding ignored{Finding::Severity::warning, "ignored_records", "", 0, {}};
  UnknownRecords unknown;
  UnjoinedLines unjoined;
  LineReader lines(file, {.comment = '#', .continued = true});
  while (lines.next()) {
    const std::string_view record = lines.word();
    unjoined.see(lines, record);
    if (record == "v") {
      soup.positions.push_back(lines.point());
    } else if (is_face(record)) {
      read_face(file, lines, soup);
    } else if (holds_geometry(record)) {
      ++ignored.count;
    } else if (!is_record_name(record)) {
      lines.reject(InputFault::syntax, quoted(record) + " is no record of OBJ");
    } else if (!holds_none(record)) {
      unknown.see(lines, record);
    }
    if (soup.positions.size() >= no_index || soup.face_count() >= no_index)
      lines.reject(InputFault::unsupported, "more vertices or faces than 32 bits count");
  }
  check_corners(file, soup);
  unjoined.tell(soup);
  unknown.tell(soup);
  ignored.message =
      std::to_string(ignored.count) + " lines, points, curves or free-form surfaces of the OBJ file were not used.";
  if (ignored.count > 0) soup.findings.push_back(std::move(ignored));
  return soup;
}

std::string obj_text(const MeshToWrite& mesh) {
  std::string text;
  for (const Vec3& p : mesh.positions) append_point(text, "v ", p);
  for (const Triangle& t : mesh.triangles) append_face(text, "f", t, first_index);
  return text;
}

std::string obj_path(const PathResult& path) {
  if (path.positions.empty()) return "# no path\n";
  std::string text, line = "l";
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    append_point(text, "v ", path.positions[i]);
    line += " " + std::to_string(i + first_index);
  }
  return text + line + "\n";
}

}  // namespace

Format obj_format() {
  return {.name = "OBJ",
          .endings = {".obj"},
          .uses = {{Content::mesh, "", ""},
                   {.content = Content::points, .read = "without faces"},
                   {.content = Content::path, .written = "a polyline"}},
          .read = read_obj,
          .write = obj_text,
          .write_path = obj_path};
}

}  // namespace geodrome
