// SPDX-License-Identifier: MIT
#include "engine/input/float32_steps.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/text_stream.hpp"
#include "engine/input/findings.hpp"
#include "engine/input/point_tree.hpp"

namespace geodrome::input {
namespace {

/// Steps up to this share of the spacing are noise that no distance shows.
constexpr double small_share = 0.05;

/// So many of the points tell the spacing.
constexpr std::size_t asked_points = 1000;

double step_at(double coordinate) {
  const float value = static_cast<float>(std::abs(coordinate));
  return static_cast<double>(std::nextafter(value, std::numeric_limits<float>::infinity())) - value;
}

/// The step where the coordinates of an axis are largest; 0 if hardly any of them there are odd multiples, as where all
/// are whole numbers.
double step_of_axis(std::span<const Vec3> positions, double Vec3::*axis) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, std::abs(p.*axis));
  const double step = step_at(largest);
  std::size_t there = 0, odd = 0;
  for (const Vec3& p : positions) {
    if (step_at(p.*axis) != step) continue;
    ++there, odd += std::fmod(std::abs(p.*axis) / step, 2) == 1;
  }
  return 16 * odd >= there ? step : 0;
}

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_edge(const Input& input) {
  std::vector<double> lengths;
  for (const Triangle& t : input.triangles)
    for (int i = 0; i < 3; ++i) lengths.push_back(distance(input.positions[t[i]], input.positions[t[(i + 1) % 3]]));
  return median(lengths);
}

double median_gap(std::span<const Vec3> points) {
  if (points.size() < 2) return 0;
  const PointTree tree = tree_of(points);
  const std::size_t stride = std::max<std::size_t>(points.size() / asked_points, 1);
  std::vector<double> gaps;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double gap = 0;  // of the two nearest one is the point itself
    for (auto at = tree.qbegin(boost::geometry::index::nearest(tree_point(points[i]), 2)); at != tree.qend(); ++at)
      gap = std::max(gap, distance(points[at->second], points[i]));
    gaps.push_back(gap);
  }
  return median(gaps);
}

/// Whether the step may be large against the spacing of points that are spread over a surface.
bool is_doubtful(double step, const Input& input) {
  const double spread = input.facts.bounding_box_diagonal / std::sqrt(static_cast<double>(input.positions.size()));
  return step > 0 && step > 0.1 * small_share * spread;
}

}  // namespace

double float32_step(std::span<const Vec3> positions) {
  for (const Vec3& p : positions)
    for (const double x : {p.x, p.y, p.z})
      if (static_cast<double>(static_cast<float>(x)) != x) return 0;
  return std::max(
      {step_of_axis(positions, &Vec3::x), step_of_axis(positions, &Vec3::y), step_of_axis(positions, &Vec3::z)});
}

void tell_float32_steps(Input& input) {
  const double step = float32_step(input.positions);
  if (!is_doubtful(step, input)) return;
  const double spacing = input.kind == InputKind::mesh ? median_edge(input) : median_gap(input.positions);
  if (!(spacing > 0 && step > small_share * spacing)) return;  // a single point has no spacing
  TextOutput text;
  text.precision(3);
  text << "The coordinates come in steps of " << step << ", as 32-bit floats have them so far from the origin; that is "
       << 100 * step / spacing << " % of the "
       << (input.kind == InputKind::mesh ? "median edge" : "spacing of the points") << ", " << spacing << ".";
  Finding finding{.count = input.positions.size(),
                  .remedy = "save 64-bit floats or text in full, or subtract a common offset before"};
  report(input.findings, std::move(finding), Finding::Severity::warning, "float32_steps", text.str());
}

}  // namespace geodrome::input
