// SPDX-License-Identifier: MIT
#include "tools/bench/samples/sheet_errors.hpp"

#include <algorithm>
#include <cstdio>

#include "tools/bench/samples/manifold_task.hpp"
#include "tools/bench/solvers/witness.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome::bench {
namespace {

constexpr std::size_t source_count = 5;
constexpr double most_seconds = 3600;
/// The chord of half a circle is shorter than its arc by pi / 2.
constexpr double longest_way = 1.6;
constexpr double too_short = 0.02;

std::size_t count_shortcuts(const std::string& kind, const SurfaceMesh& mesh) {
  std::size_t count = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    if (mesh.twins()[h] != no_index && mesh.twins()[h] < h) continue;
    const Vec3 &a = mesh.positions()[mesh.from(h)], &b = mesh.positions()[mesh.to(h)];
    count += shapes::sheet_distance(kind, a, b) > longest_way * distance(a, b);
  }
  return count;
}

using Rows = std::vector<std::vector<double>>;

/// The rows and columns of points that are vertices.
double shortest_between_vertices(const PlacedSurface& surface, const std::vector<Index>& sources, const Rows& truth,
                                 const Rows& computed) {
  std::vector<char> is_vertex(computed.front().size(), 0);
  for (const Index s : surface.sample->sample_of_vertex)
    if (s != no_index) is_vertex[s] = 1;
  Rows known, found;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!is_vertex[sources[i]]) continue;
    known.emplace_back(), found.emplace_back();
    for (std::size_t j = 0; j < is_vertex.size(); ++j)
      if (is_vertex[j]) known.back().push_back(truth[i][j]), found.back().push_back(computed[i][j]);
  }
  return known.empty() ? 0 : distance_errors(known, found).far.largest_under;
}

}  // namespace

SheetErrors sheet_errors(const std::string& kind, const PointSample& sample, const PlacedSurface& surface,
                         const PluginHost& host, std::uint64_t seed) {
  Witness solver(host.load<ShortestPathSolver>("chen_han"), surface.mesh, most_seconds);
  std::vector<SurfacePoint> places;
  for (const Place& place : surface.places) places.push_back(place.at);
  const std::vector<Index> sources = choose_rows(sample.size(), source_count, seed);
  Rows truth, computed;
  for (const Index s : sources) {
    const Source start{places[s]};
    solver.run({&start, 1}, {.targets = places, .keep = Keep::targets});
    computed.push_back(solver.at(places));
    truth.emplace_back();
    for (std::size_t j = 0; j < sample.size(); ++j) {
      truth.back().push_back(shapes::sheet_distance(kind, sample.points[s], sample.points[j]));
      computed.back()[j] = std::max(computed.back()[j], distance(sample.points[s], sample.points[j]));
    }
  }
  return {distance_errors(truth, computed), shortest_between_vertices(surface, sources, truth, computed),
          count_shortcuts(kind, *surface.mesh)};
}

std::string how_wrong(const SheetErrors& errors) {
  char text[120] = "";
  if (errors.shortcuts > 0)
    std::snprintf(text, sizeof text, "%zu edges join two parts of the sheet", errors.shortcuts);
  else if (errors.short_vertices > too_short)
    std::snprintf(text, sizeof text, "vertices are %.2g %% too near to each other", 100 * errors.short_vertices);
  return text;
}

}  // namespace geodrome::bench
