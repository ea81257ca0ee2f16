// SPDX-License-Identifier: MIT
#include "engine/formats/off_reader.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/off_layout.hpp"

namespace geodrome::input {
namespace {

std::vector<OffLayout> layouts_of(const SourceFile& file) {
  std::vector<std::size_t> columns = off_columns(file);
  columns.insert(columns.begin(), 0);
  std::vector<OffLayout> layouts;
  for (const bool edges_on_a_line : {false, true})
    for (const std::size_t count : columns)
      for (const bool faces_on_lines : {true, false}) layouts.push_back({count, faces_on_lines, edges_on_a_line});
  return layouts;
}

bool same_numbers(const Soup& a, const Soup& b) {
  const auto same = [](const Vec3& p, const Vec3& q) { return p == q || (!is_finite(p) && !is_finite(q)); };
  return a.corners == b.corners && a.face_end == b.face_end && std::ranges::equal(a.positions, b.positions, same);
}

/// The reading that uses every number of the file; none if there is none. Rejects a file with several that differ.
/// `known`: what is complete already, if anything is.
std::optional<OffReading> read_completely(const SourceFile& file, std::span<const OffLayout> layouts,
                                          std::optional<OffReading> known) {
  for (const OffLayout& layout : layouts) {
    OffReading reading;
    try {
      reading = read_off_with(file, layout);
    } catch (const InputError&) {
      continue;
    }
    if (!reading.complete) continue;
    if (known && !same_numbers(known->soup, reading.soup))
      reject(file, InputFault::syntax,
             "its numbers can be read in more than one way, as to where vertices and faces begin",
             "put every vertex and every face on a line of its own, or convert the file to PLY");
    if (!known) known = std::move(reading);
  }
  return known;
}

/// Where vertices follow the counts on their line, what is wrong with the stream is meant, not with the lines.
void reject_stream(const SourceFile& file) {
  LineReader lines(file, {.comment = '#'});
  lines.next();
  if (lines.word().ends_with("OFF") && lines.at_line_end()) lines.next();
  std::size_t counts = 0;
  while (!lines.word().empty()) ++counts;
  if (counts <= 3) return;
  read_off_with(file, {off_columns(file)[0], false, false});
  lines.reject(InputFault::syntax, "the vertices and faces announced here do not use all numbers of the file");
}

void warn(Soup& soup, const char* code, const std::string& message) {
  soup.findings.push_back({Finding::Severity::warning, code, message, 1, {}});
}

Soup told(OffReading reading) {
  if (reading.torn != 0)
    warn(reading.soup, "rows_across_lines",
         "Vertices or faces begin and end within lines, the first in line " + std::to_string(reading.torn) +
             "; the numbers were read one after the other.");
  if (reading.mixed != 0)
    warn(reading.soup, "colours_differ",
         "Colours of faces differ in length, which shows first in line " + std::to_string(reading.mixed) +
             ": is a corner missing?");
  return std::move(reading.soup);
}

}  // namespace

Soup read_off(const SourceFile& file) {
  const std::vector<OffLayout> layouts = layouts_of(file);
  std::optional<OffReading> by_lines;
  std::optional<InputError> fault;
  try {
    by_lines = read_off_with(file, layouts[0]);
  } catch (const InputError& error) {
    fault = error;
  }
  const bool complete = by_lines && by_lines->complete;
  if (complete && !by_lines->coloured) return told(std::move(*by_lines));
  // Numbers taken as colours may be faces, and none else.
  const auto others = complete ? std::span(layouts).subspan(1, 1) : std::span(layouts).subspan(1);
  std::optional<OffReading> found = read_completely(file, others, complete ? std::move(by_lines) : std::nullopt);
  if (!found && fault) {
    reject_stream(file);
    throw *fault;
  }
  if (!found) {
    note_trailing_data(by_lines->soup);
    return told(std::move(*by_lines));
  }
  return told(std::move(*found));
}

}  // namespace geodrome::input
