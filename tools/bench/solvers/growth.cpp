// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/growth.hpp"

#include <cmath>
#include <cstdio>
#include <ostream>

#include "engine/report/median.hpp"
#include "tools/bench/solvers/fit.hpp"
#include "tools/bench/solvers/runner.hpp"

namespace geodrome::bench {
namespace {

/// None where a logarithm or a slope does not exist.
Figure exponent(const std::vector<double>& faces, const std::vector<Figure>& figures) {
  std::vector<double> values;
  for (const Figure& figure : figures) {
    if (!figure || !(*figure > 0)) return std::nullopt;
    values.push_back(*figure);
  }
  const double fitted = fitted_exponent(faces, values);
  return std::isfinite(fitted) ? Figure(fitted) : std::nullopt;
}

}  // namespace

GrowthPoint growth_point(const Plugin<ShortestPathSolver>& solver, const MeshPtr& mesh, const GrowthOptions& options) {
  SolverRunner runner(solver, mesh);
  runner.prepare();
  runner.make_search();
  std::vector<Figure> windows, bytes;
  std::vector<double> seconds;
  for (const Index source : choose_sources(*mesh, options.sources, options.seed)) {
    runner.query(source);
    windows.push_back(runner.figures().windows), bytes.push_back(runner.figures().bytes);
    std::vector<double> runs;
    for (std::size_t run = 0; run < options.runs; ++run) runs.push_back(runner.query(source));
    seconds.push_back(median(runs));
  }
  return {mesh->face_count(), edge_count(*mesh), median_figure(windows), median(seconds), largest_figure(bytes)};
}

GrowthExponents exponents_of(std::span<const GrowthPoint> points) {
  std::vector<double> faces;
  std::vector<Figure> windows, seconds;
  for (const GrowthPoint& point : points) {
    faces.push_back(static_cast<double>(point.faces));
    windows.push_back(point.windows), seconds.push_back(point.seconds);
  }
  return {exponent(faces, windows), exponent(faces, seconds)};
}

void print_growth_head(std::ostream& out) {
  char line[200];
  std::snprintf(line, sizeof line, "%-16s %9s %13s %15s %11s %12s %10s\n", "shape", "faces", "windows",
                "windows an edge", "seconds", "ns a window", "search MB");
  out << line;
}

void print(std::ostream& out, const std::string& shape, const GrowthPoint& point) {
  char line[200];
  std::snprintf(line, sizeof line, "%-16s %9zu %13s %15s %11.6f %12s %10s\n", shape.c_str(), point.faces,
                figure_text(point.windows, 0).c_str(),
                figure_text(quotient(point.windows, static_cast<double>(point.edges)), 2).c_str(), point.seconds,
                figure_text(quotient(1e9 * point.seconds, point.windows), 1).c_str(),
                figure_text(quotient(point.bytes, 1e6), 2).c_str());
  out << line << std::flush;
}

void print(std::ostream& out, const std::string& shape, const GrowthExponents& exponents) {
  char line[200];
  std::snprintf(line, sizeof line, "%-16s exponents in faces: windows %s, seconds %s\n", shape.c_str(),
                figure_text(exponents.windows, 3).c_str(), figure_text(exponents.seconds, 3).c_str());
  out << line << std::flush;
}

}  // namespace geodrome::bench
