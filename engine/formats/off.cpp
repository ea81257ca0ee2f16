// SPDX-License-Identifier: MIT
#include <string_view>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/off_reader.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text_output.hpp"

// Object File Format as Geomview, CGAL and MeshLab write it. It is read by off_reader.cpp.
namespace geodrome {
namespace {

using namespace input;

/// An OFF keyword with whatever may stand before and after it: COFF, STNOFF, 4OFF, OFF6 (a count without a blank).
Evidence off_evidence(const SourceFile& file) {
  const std::string_view word = first_word(file);
  const std::size_t off = word.find("OFF");
  const bool is_keyword = off != word.npos && word.substr(0, off).find_first_not_of("STCN4n") == word.npos;
  return is_keyword ? Evidence::keyword : Evidence::none;
}

std::string off_text(const MeshToWrite& mesh) {
  std::string text =
      "OFF\n" + std::to_string(mesh.positions.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  for (const Vec3& p : mesh.positions) append_point(text, "", p);
  for (const Triangle& t : mesh.triangles) append_face(text, "3", t, 0);
  return text;
}

}  // namespace

Format off_format() {
  return {.name = "OFF",
          .endings = {".off"},
          .uses = {{Content::mesh, "", ""}, {Content::points, "without faces", ""}},
          .evidence = off_evidence,
          .read = read_off,
          .write = off_text};
}

}  // namespace geodrome
