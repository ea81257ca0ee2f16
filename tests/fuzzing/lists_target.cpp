// SPDX-License-Identifier: MIT
// Lists of points and of pairs: the syntax, and the places on a small mesh. The first byte: 1 the text itself instead
// of a file (points); 2 other line ends.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/formats/number_text.hpp"
#include "engine/search/named_points.hpp"
#include "tests/fuzzing/memory_file.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

using Kind = PointEntry::Kind;

const MemoryFile& list_file() {
  static const MemoryFile file;
  return file;
}

/// Two triangles of the unit square, a quadrangle beside them, and a vertex on no face.
struct Ground {
  Ground() {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}};
    const std::vector<Triangle> faces{{0, 1, 2}, {0, 2, 3}};
    Observer silent;
    input = make_input({.positions = positions, .faces = faces});
    surface = make_surface(input, PluginHost(), {}, silent);
  }
  Input input;
  PlacedSurface surface;
};

const Ground& ground() {
  static const Ground square;
  return square;
}

void demand_sound_numbers(const std::array<double, 3>& b) {
  demand(std::ranges::all_of(b, [](double x) { return x >= 0 && x <= 1; }), "barycentric coordinates are shares");
  demand(std::abs(std::accumulate(b.begin(), b.end(), 0.0) - 1) <= 1e-15, "barycentric coordinates sum to 1");
}

void demand_sound(const PointEntry& entry) {
  demand(std::ranges::all_of(entry.numbers, [](double x) { return std::isfinite(x); }), "numbers are finite");
  demand(entry.start >= 0 && std::isfinite(entry.start), "start distances are finite and not negative");
  if (entry.kind == Kind::on_face) demand_sound_numbers(entry.numbers);
}

void demand_sound(const NamedPoint& point) {
  const SurfaceMesh& mesh = *ground().surface.mesh;
  demand(point.row == no_index || point.row < ground().input.facts.rows, "rows are in range");
  demand(point.start >= 0 && std::isfinite(point.start), "start distances are finite and not negative");
  demand(is_finite(point.place.position), "places are finite");
  demand(point.place.vertex == no_index || point.place.vertex < mesh.vertex_count(), "vertices are in range");
  if (point.place.state != Place::State::on_surface) return;
  demand(point.place.at.face < mesh.face_count(), "faces are in range");
  demand_sound_numbers(point.place.at.b);
}

std::string text_of(const PointEntry& entry) {
  const auto& [x, y, z] = entry.numbers;
  const std::string numbers = number_text(x) + " " + number_text(y) + " " + number_text(z);
  if (entry.kind == Kind::row && entry.count == 1) return std::to_string(entry.index);
  if (entry.kind == Kind::row)
    return std::to_string(entry.index) + ":" + std::to_string(entry.index + (entry.count - 1) * entry.step + 1) + ":" +
           std::to_string(entry.step);
  return entry.kind == Kind::position ? numbers : std::to_string(entry.index) + " " + numbers;
}

/// Coordinates of a face are divided by their sum each time they are read, which may move the last digit.
bool same(const PointEntry& a, const PointEntry& b) {
  bool near = true;
  for (std::size_t i = 0; i < 3; ++i)
    near &= a.kind == Kind::on_face ? std::abs(a.numbers[i] - b.numbers[i]) <= 1e-15 : a.numbers[i] == b.numbers[i];
  return a.kind == b.kind && a.index == b.index && a.count == b.count && (a.count == 1 || a.step == b.step) &&
         a.start == b.start && near;
}

bool same_entries(const Selection& a, const Selection& b) {
  return a.all == b.all && std::ranges::equal(a.entries, b.entries, same);
}

bool same_pairs(const PairSelection& a, const PairSelection& b) {
  return std::ranges::equal(a.pairs, b.pairs, [](const PairEntry& p, const PairEntry& q) {
    return same(p.from, q.from) && same(p.to, q.to);
  });
}

std::string text_of(const Selection& selection) {
  std::string text;
  for (const PointEntry& entry : selection.entries)
    text += text_of(entry) + (entry.start > 0 ? " + " + number_text(entry.start) : "") + "\n";
  return text;
}

std::string text_of(const PairSelection& selection) {
  std::string text;
  for (const auto& [from, to] : selection.pairs) text += text_of(from) + ", " + text_of(to) + "\n";
  return text;
}

Selection points_in(std::string_view text) {
  list_file().hold(text);
  return parse_selection("@" + list_file().path());
}

PairSelection pairs_in(std::string_view text) {
  list_file().hold(text);
  return parse_pairs(list_file().path());
}

/// Rows and words on the command line name no file in their messages.
void check_text_itself(std::string_view text) {
  if (text.starts_with('@')) return;
  const auto list = read_or_refusal("", text, [&] { return parse_selection(std::string(text)); });
  if (!list) return;
  demand(list->all != !list->entries.empty(), "a list names points, or all");
  for (const PointEntry& entry : list->entries) demand_sound(entry);
}

bool may_end_otherwise(std::string_view text) { return text.find('\r') == text.npos; }

}  // namespace

void check_points(std::string_view input) {
  const Choices choices(input);
  const std::string_view text = rest_of(input);
  if (choices.bit(0)) return check_text_itself(text);
  const std::string& file = list_file().path();
  const auto list = read_or_refusal(file, text, [&] { return points_in(text); });
  if (!list) return;
  demand(!list->entries.empty() && !list->all && list->file == file, "a list names a point");
  for (const PointEntry& entry : list->entries) demand_sound(entry);
  demand(same_entries(points_in(text_of(*list)), *list), "a list that is written reads back");
  if (choices.bit(1) && may_end_otherwise(text))
    demand(same_entries(points_in(with_windows_line_ends(text)), *list), "line ends of Windows change nothing");
  const auto places = read_or_refusal(file, text, [&] { return resolve(*list, ground().input, ground().surface); });
  if (!places) return;
  demand(places->size() == list->count(), "every point of a list has a place");
  for (const NamedPoint& point : *places) demand_sound(point);
}

void check_pairs(std::string_view input) {
  const std::string_view text = rest_of(input);
  const std::string& file = list_file().path();
  const auto list = read_or_refusal(file, text, [&] { return pairs_in(text); });
  if (!list) return;
  demand(!list->pairs.empty() && list->hash.size() == 32, "a list names a pair and has a hash");
  for (const auto& [from, to] : list->pairs) {
    demand_sound(from), demand_sound(to);
    demand(from.start == 0 && to.start == 0, "pairs have no start distances");
  }
  demand(same_pairs(pairs_in(text_of(*list)), *list), "a list that is written reads back");
  if (Choices(input).bit(1) && may_end_otherwise(text))
    demand(same_pairs(pairs_in(with_windows_line_ends(text)), *list), "line ends of Windows change nothing");
  const auto places = read_or_refusal(file, text, [&] { return resolve(*list, ground().input, ground().surface); });
  if (!places) return;
  for (const auto& [from, to] : places->pairs) demand_sound(from), demand_sound(to);
}

std::vector<std::string> point_seeds() {
  const std::string file(1, '\0'), other_ends(1, '\2'), itself(1, '\1');
  return {file + "0\n3 # a row\n\n",
          other_ends + "0.5 0.25 7\n1 0.2 0.3 0.5 + 2.5\n4\n",
          other_ends + "\xEF\xBB\xBF# c\n\t0 1 0 0 + 0\n+1e-3 -.5 2\n",
          file + "0 0.333333 0.333333 0.333334\n1e300 -1e300 1e-300\n2 + 1e10\n",
          itself + "all",
          itself + "0,3,17",
          itself + "1,"};
}

std::vector<std::string> pair_seeds() {
  const std::string file(1, '\0'), other_ends(1, '\2');
  return {file + "0, 3\n1,2 # near\n", other_ends + "3, 0.5 1 0.2\n0 0.2 0.3 0.5, 1 0.1 0.1 0.8\n",
          other_ends + "\xEF\xBB\xBF# c, d\n\t2\t,\t3\t\n4, 4", file + "  0.5 0 0 ,2\n1e300 -1e300 1e-300, +1 2 3\n"};
}

}  // namespace geodrome::fuzzing
