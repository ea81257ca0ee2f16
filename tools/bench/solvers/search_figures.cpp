// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/search_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "engine/report/median.hpp"

namespace geodrome::bench {
namespace {

Figure named(std::span<const Counter> counters, std::string_view name) {
  for (const Counter& counter : counters)
    if (counter.name == name) return static_cast<double>(counter.value);
  return std::nullopt;
}

/// The values of all, or nothing if one is none.
std::vector<double> values_of(std::span<const Figure> figures) {
  std::vector<double> values;
  for (const Figure& figure : figures) {
    if (!figure) return {};
    values.push_back(*figure);
  }
  return values;
}

}  // namespace

SearchFigures figures_of(std::span<const Counter> counters) {
  return {named(counters, "windows_propagated"), named(counters, "largest_search_bytes")};
}

Figure quotient(Figure dividend, Figure divisor) {
  if (!dividend || !divisor || *divisor == 0) return std::nullopt;
  return *dividend / *divisor;
}

Figure median_figure(std::span<const Figure> figures) {
  const std::vector<double> values = values_of(figures);
  return values.empty() ? Figure() : median(values);
}

Figure largest_figure(std::span<const Figure> figures) {
  const std::vector<double> values = values_of(figures);
  return values.empty() ? Figure() : *std::max_element(values.begin(), values.end());
}

std::string figure_text(Figure figure, int decimals) {
  if (!figure || !std::isfinite(*figure)) return "-";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, *figure);
  return text;
}

std::size_t edge_count(const SurfaceMesh& mesh) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(3 * mesh.face_count());
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) edges.push_back(std::minmax({mesh.from(h), mesh.to(h)}));
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

}  // namespace geodrome::bench
