// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>

#include "engine/formats/bytes.hpp"
#include "engine/formats/line_reader.hpp"
#include "engine/formats/table.hpp"

// STL names no vertices: corners at exactly the same place are one vertex, numbered by its first appearance.
namespace geodrome {
namespace {

using namespace input;

constexpr std::size_t header_bytes = 80, body_offset = 84, facet_bytes = 50, normal_bytes = 12;

bool same_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

std::uint32_t announced_facets(const SourceFile& file) {
  return load<std::uint32_t>(file.bytes.data() + header_bytes, std::endian::little);
}

/// The size is that of a binary STL with the announced number of facets.
bool has_size_of_binary_stl(const SourceFile& file) {
  return file.bytes.size() >= body_offset && file.bytes.size() == body_offset + facet_bytes * announced_facets(file);
}

// Merging needs numbers that compare: what is not finite is refused here already.
void add_corner(const SourceFile& file, const Vec3& corner, std::vector<Vec3>& corners) {
  if (!is_finite(corner))
    reject(file, InputFault::nonfinite,
           "corner " + std::to_string(corners.size() % 3) + " of facet " + std::to_string(corners.size() / 3) +
               " is not finite");
  corners.push_back(corner);
}

bool is_text_stl(const SourceFile& file) {
  const std::string_view start = std::string_view(file.bytes).substr(0, 1024);  // a binary one has zeros before that
  LineReader lines(file);
  return !has_size_of_binary_stl(file) && start.find('\0') == start.npos && lines.next() &&
         same_word(lines.word(), "solid");
}

Soup soup_of(const SourceFile& file, std::vector<Vec3> corners) {
  if (corners.size() >= no_index) reject(file, InputFault::unsupported, "more corners than 32 bits count");
  Soup soup{.vertices_by_place = true};
  soup.corners.resize(corners.size());
  std::iota(soup.corners.begin(), soup.corners.end(), Index{0});
  for (std::size_t end = 3; end <= corners.size(); end += 3) soup.face_end.push_back(end);
  soup.positions = std::move(corners);
  return soup;
}

Soup parse_binary(const SourceFile& file) {
  if (file.bytes.size() < body_offset)
    reject(file, InputFault::truncated,
           "the file has " + std::to_string(file.bytes.size()) + " bytes, a binary STL at least 84");
  const std::size_t count = announced_facets(file), end = body_offset + count * facet_bytes;
  if (file.bytes.size() < end)
    reject(file, InputFault::truncated,
           "the header announces " + std::to_string(count) + " facets, there is room for " +
               std::to_string((file.bytes.size() - body_offset) / facet_bytes));
  std::vector<Vec3> corners;
  corners.reserve(3 * count);
  for (std::size_t at = body_offset; at < end; at += facet_bytes)
    for (std::size_t i = 0; i < 3; ++i) {
      const char* from = file.bytes.data() + at + normal_bytes + 12 * i;
      const auto coordinate = [&](int axis) -> double { return load<float>(from + 4 * axis, std::endian::little); };
      add_corner(file, {coordinate(0), coordinate(1), coordinate(2)}, corners);
    }
  Soup soup = soup_of(file, std::move(corners));
  if (end < file.bytes.size()) note_trailing_data(soup);
  return soup;
}

// The grammar is a cycle of lines; each has its word, and the place in the cycle where it may stand.
class TextParser {
 public:
  explicit TextParser(const SourceFile& file) : file_(file), lines_(file) {}

  std::vector<Vec3> corners() {
    while (lines_.next()) read_line(lines_.word());
    if (state_ != State::outside)
      reject(file_, InputFault::truncated,
             "the file ends inside a solid, after " + std::to_string(corners_.size() / 3) + " facets");
    return std::move(corners_);
  }

 private:
  enum class State { outside, solid, facet, loop, after_loop };

  void read_line(std::string_view word) {
    if (same_word(word, "solid")) {
      go(State::outside, State::solid, word);
    } else if (same_word(word, "facet")) {
      go(State::solid, State::facet, word);
    } else if (same_word(word, "outer")) {
      go(State::facet, State::loop, word);
      corners_of_loop_ = 0;
    } else if (same_word(word, "vertex")) {
      go(State::loop, State::loop, word);
      if (++corners_of_loop_ > 3) lines_.reject(InputFault::syntax, "a facet has more than three corners");
      add_corner(file_, lines_.point(), corners_);
    } else if (same_word(word, "endloop")) {
      go(State::loop, State::after_loop, word);
      if (corners_of_loop_ < 3) lines_.reject(InputFault::syntax, "a facet has fewer than three corners");
    } else if (same_word(word, "endfacet")) {
      go(State::after_loop, State::solid, word);
    } else if (same_word(word, "endsolid")) {
      go(State::solid, State::outside, word);
    } else {
      lines_.reject(InputFault::syntax, quoted(word) + " is no word of STL");
    }
  }

  void go(State from, State to, std::string_view word) {
    if (state_ != from) lines_.reject(InputFault::syntax, quoted(word) + " does not belong here");
    state_ = to;
  }

  const SourceFile& file_;
  LineReader lines_;
  State state_ = State::outside;
  int corners_of_loop_ = 0;
  std::vector<Vec3> corners_;
};

Soup read_stl(const SourceFile& file) {
  return is_text_stl(file) ? soup_of(file, TextParser(file).corners()) : parse_binary(file);
}

Evidence stl_evidence(const SourceFile& file) {
  if (has_size_of_binary_stl(file)) return Evidence::size;
  return first_word(file) == "solid" ? Evidence::keyword : Evidence::none;
}

Vec3 unit_normal(const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 n = cross(q - p, r - p);
  const double length = norm(n);
  return length > 0 && std::isfinite(length) ? n / length : Vec3{};
}

std::string stl_bytes(const MeshToWrite& mesh) {
  std::string bytes = "binary STL";  // must not start with "solid"
  bytes.resize(header_bytes, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  const auto append = [&](const Vec3& p) {
    for (const double coordinate : {p.x, p.y, p.z}) append_float32(bytes, coordinate, mesh.file, "the floats of STL");
  };
  for (const Triangle& t : mesh.triangles) {
    append(unit_normal(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]));
    for (const Index v : t) append(mesh.positions[v]);
    append_little_endian(bytes, std::uint16_t{0});
  }
  return bytes;
}

}  // namespace

Format stl_format() {
  return {.name = "STL",
          .endings = {".stl"},
          .uses = {{Content::mesh, "text, binary", "binary, float"}},
          .evidence = stl_evidence,
          .read = read_stl,
          .write = stl_bytes,
          .mesh_numbers = MeshNumbers::float32};
}

}  // namespace geodrome
