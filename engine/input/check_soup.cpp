// SPDX-License-Identifier: MIT
#include "engine/input/check_soup.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/input/findings.hpp"
#include "engine/input/float32_steps.hpp"
#include "engine/input/merge.hpp"
#include "engine/input/mesh_check.hpp"
#include "engine/input/polygons.hpp"
#include "engine/input/weights.hpp"

namespace geodrome {
namespace {

using namespace input;
using Severity = Finding::Severity;

// Solvers take fourth powers of lengths at most when nothing is scaled, and squares of squares must stay in double's
// range by far; nobody measures in such units either.
constexpr double largest = 1e100, smallest = 1e-100;

/// What messages call an element that stands for one row alone, wherever rows before it were dropped.
std::string row_name(const Origin& origin, const Input& input, std::size_t element) {
  const auto found = std::ranges::find(input.element_of_row, static_cast<Index>(element));
  const auto row = static_cast<std::size_t>(found - input.element_of_row.begin());
  return input.kind == InputKind::points ? origin.point(row) : origin.vertex(row);
}

/// Precondition: nothing is merged yet.
double checked_diagonal(const Origin& origin, const Input& input) {
  const std::string rescale = "rescale the input to ordinary numbers";
  const std::vector<Vec3>& positions = input.positions;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high = -low;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3& p = positions[i];
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > largest)
      origin.reject(InputFault::range, row_name(origin, input, i) + " has a coordinate beyond 1e100", rescale);
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  if (positions.empty()) return 0;
  const Vec3 size = high - low;
  const double diagonal = std::hypot(size.x, size.y, size.z);
  if (diagonal > largest) origin.reject(InputFault::range, "the diagonal of the bounding box is beyond 1e100", rescale);
  if (diagonal > 0 && diagonal < smallest)
    origin.reject(InputFault::range, "the diagonal of the bounding box is below 1e-100", rescale);
  return diagonal;
}

std::string short_text(double value) {
  TextOutput text;
  text.precision(3);
  text << value;
  return text.str();
}

void check_weld(const ReadOptions& options) {
  const double tolerance = options.weld_tolerance;
  if (!(tolerance >= 0 && tolerance <= largest))
    throw OptionError("the tolerance of welding is a number from 0 to 1e100, in the units of the input");
  if (tolerance > 0 && !options.weld)
    throw OptionError("a tolerance of welding is given, but nothing is welded", remedies::weld());
}

std::vector<Index> identity(std::size_t count) {
  std::vector<Index> indices(count);
  std::iota(indices.begin(), indices.end(), Index{0});
  return indices;
}

void use_merged(MergedPoints merged, Input& input) {
  input.facts.merged += input.positions.size() - merged.positions.size();
  for (Index& element : input.element_of_row)
    if (element != no_index) element = merged.element_of_row[element];
  input.positions = std::move(merged.positions);
}

// The rows whose point shares its place with an earlier one.
Finding merged_rows(const MergedPoints& merged, const Input& input) {
  Finding found;
  Index places = 0;
  for (Index row = 0; row < input.element_of_row.size(); ++row) {
    const Index element = input.element_of_row[row];
    if (element == no_index) continue;
    if (merged.element_of_row[element] == places)
      ++places;
    else
      add_element(found, row);
  }
  return found;
}

void drop_nonfinite(const Origin& origin, const ReadOptions& options, Input& input) {
  Finding dropped;
  std::vector<Vec3> kept;
  for (Index row = 0; row < input.positions.size(); ++row) {
    const bool finite = is_finite(input.positions[row]);
    if (!finite && !options.drop_nonfinite)
      origin.reject(InputFault::nonfinite, origin.point(row) + " is not finite", remedies::drop_nonfinite());
    input.element_of_row[row] = finite ? static_cast<Index>(kept.size()) : no_index;
    if (finite)
      kept.push_back(input.positions[row]);
    else
      add_element(dropped, row);
  }
  input.positions = std::move(kept);
  const std::size_t count = input.facts.dropped = dropped.count;
  report(input.findings, std::move(dropped), Severity::warning, "dropped_nonfinite",
         counted(count, "point that is not finite was", "points that are not finite were") +
             " dropped; their rows hold NaN.");
}

void make_cloud(const Origin& origin, const ReadOptions& options, const Soup& soup, Input& input) {
  if (!options.weights.empty() || !soup.face_weights.empty()) reject_weights_of_points(origin);
  if (options.weld_tolerance > 0)
    origin.reject(InputFault::unsupported, "a tolerance of welding is for meshes, but the input is points",
                  "leave it out: points at the same place stand for each other anyway");
  if (soup.face_count() > 0)
    input.findings.push_back(
        {Severity::note,
         "faces_not_used",
         (origin.is_file() ? "The file is read as points: its " : "The arrays are taken as points: their ") +
             counted(soup.face_count(), "face was", "faces were") + " not used, its vertices all were.",
         soup.face_count(),
         {}});
  drop_nonfinite(origin, options, input);
  if (input.positions.empty())
    origin.reject(InputFault::empty, origin.is_file() ? "the file holds no points" : "positions is empty");
  input.facts.bounding_box_diagonal = checked_diagonal(origin, input);
  MergedPoints merged = merge_equal_points(input.positions);
  Finding rows = merged_rows(merged, input);
  const std::size_t count = rows.count;
  report(input.findings, std::move(rows), Severity::warning, "merged_points",
         counted(count, "point is", "points are") +
             " at the same place as an earlier one and stand for it, at distance 0.");
  use_merged(std::move(merged), input);
  tell_float32_steps(input);
}

void weld(const Origin& origin, double tolerance, Input& input) {
  MergedWithin within = merge_points_within(input.positions, tolerance);
  if (within.chained != no_index)
    origin.reject(InputFault::range,
                  "welding within " + number_text(tolerance) + " would move " +
                      row_name(origin, input, within.chained) + " farther than that, to " +
                      row_name(origin, input, within.chained_to) + ", over vertices between them",
                  "choose a tolerance well below the length of the edges");
  Finding rows = merged_rows(within.merged, input);
  const std::size_t count = rows.count;
  const std::string where =
      tolerance == 0 ? " at the same place."
                     : " within " + number_text(tolerance) + ", at most " + short_text(within.moved) + " away.";
  report(input.findings, std::move(rows), Severity::warning, "welded_vertices",
         counted(count, "vertex was", "vertices were") + " merged into an earlier one" + where);
  use_merged(std::move(within.merged), input);
}

void tell_of_faces(Polygons& polygons, Triangulated& faces, Input& input) {
  input.facts.degenerate_faces_dropped = polygons.degenerate.count;
  input.facts.polygons_split = faces.polygons_split;
  const std::size_t degenerate = polygons.degenerate.count, repeated = polygons.repeated.count,
                    nonplanar = faces.nonplanar.count;
  report(input.findings, std::move(polygons.degenerate), Severity::warning, "degenerate_faces",
         counted(degenerate, "face has", "faces have") + " fewer than three different corners, dropped.");
  report(input.findings, std::move(polygons.repeated), Severity::warning, "repeated_corners",
         counted(repeated, "polygon names", "polygons name") + " a corner twice in a row, which was taken as one.");
  report(input.findings, std::move(faces.nonplanar), Severity::warning, "nonplanar_polygons",
         counted(nonplanar, "polygon is", "polygons are") + " not planar: the surface depends on how they were split.");
  Finding split;
  split.count = faces.polygons_split;
  report(input.findings, std::move(split), Severity::note, "polygons_split",
         counted(faces.polygons_split, "polygon was", "polygons were") + " split into triangles.");
}

void make_mesh(const Origin& origin, const ReadOptions& options, Soup& soup, Input& input) {
  for (std::size_t v = 0; v < input.positions.size(); ++v)
    if (!is_finite(input.positions[v]))
      origin.reject(InputFault::nonfinite, origin.vertex(v) + " is not finite", remedies::finite_points());
  input.facts.bounding_box_diagonal = checked_diagonal(origin, input);
  if (options.weld) weld(origin, options.weld_tolerance, input);
  Polygons polygons = clean_faces(soup, input.element_of_row);
  if (polygons.size() == 0)
    origin.reject(InputFault::degenerate, "no face has three different corners", remedies::take_vertices());
  Triangulated faces = triangulate(origin, polygons, input.positions);
  tell_of_faces(polygons, faces, input);
  input.triangles = std::move(faces.triangles);
  input.face_of_triangle = std::move(faces.face_of_triangle);
  use_weights(origin, options.weights, soup, input);
  check_mesh(polygons, input);
}

}  // namespace

namespace input {

Input check_soup(const Origin& origin, const ReadOptions& options, Soup soup, std::string hash) {
  check_weld(options);
  Input input{.file = origin.file(), .format = soup.format, .hash = std::move(hash)};
  if (soup.positions.empty())
    origin.reject(InputFault::empty, origin.is_file() ? "the file holds no points" : "positions is empty");
  input.kind = options.as.value_or(soup.face_count() > 0 ? InputKind::mesh : InputKind::points);
  if (input.kind == InputKind::mesh && soup.face_count() == 0)
    origin.reject(
        InputFault::empty,
        origin.is_file() ? "a mesh is asked for, but the file has no faces" : "a mesh is asked for, but faces is empty",
        remedies::take_points());
  input.facts.rows = soup.positions.size();
  input.facts.faces_in_file = soup.face_count();
  input.findings = std::move(soup.findings);
  input.positions = std::move(soup.positions);
  input.element_of_row = identity(input.positions.size());
  if (input.kind == InputKind::mesh)
    make_mesh(origin, options, soup, input);
  else
    make_cloud(origin, options, soup, input);
  return input;
}

}  // namespace input

}  // namespace geodrome
