// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/row_choice.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace geodrome::chen_han {
namespace {

double counter(const Propagation& propagation, std::string_view name) {
  for (const Counter& counter : propagation.counters())
    if (counter.name == name) return static_cast<double>(counter.value);
  return 0;
}

void add_windows(const Propagation& propagation, double weight, SearchCounts& counts) {
  counts.passes += weight * counter(propagation, "half_edges_passed");
  counts.windows += weight * counter(propagation, "windows_propagated");
}

/// The vertices beside one of very many faces, and the others.
std::array<std::vector<Index>, 2> by_hubs(const PackedMesh& surface) {
  constexpr std::size_t many_faces = 128;
  std::vector<bool> beside(surface.vertex_count());
  for (Index v = 0; v < surface.vertex_count(); ++v) {
    if (surface.corners(v).size() <= many_faces) continue;
    for (const Index corner : surface.corners(v))
      beside[surface.from(SurfaceMesh::next(corner))] = beside[surface.from(SurfaceMesh::previous(corner))] = true;
  }
  std::array<std::vector<Index>, 2> parts;
  for (Index v = 0; v < surface.vertex_count(); ++v) parts[beside[v] ? 0 : 1].push_back(v);
  return parts;
}

std::vector<Index> spread(std::span<const Index> vertices, std::size_t count) {
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(vertices[(2 * i + 1) * vertices.size() / (2 * count)]);
  return chosen;
}

}  // namespace

std::vector<Index> samples(std::span<const Index> sources) {
  constexpr std::size_t most = 8, one_in = 256;
  return spread(sources, std::clamp<std::size_t>(sources.size() / one_in, 1, most));
}

bool near_lists_take_more(const PackedMesh& surface, const Settings& settings, double most_work,
                          const RunContext& context) {
  constexpr std::size_t most_samples = 16;
  double work = 0;
  for (const std::vector<Index>& vertices : by_hubs(surface)) {
    const std::vector<Index> some = spread(vertices, std::min(most_samples, vertices.size()));
    if (some.empty()) continue;
    const double sampled =
        count_near(surface, settings, DirectGround::near_count, some, most_work - work, context).work();
    if (sampled > most_work - work) return true;
    work += sampled * static_cast<double>(vertices.size()) / static_cast<double>(some.size());
    if (work > most_work) return true;
  }
  return false;
}

SearchCounts count_plain(const PackedMesh& surface, const Settings& settings, std::span<const Index> samples,
                         double distance, const RunContext& context) {
  Propagation propagation(surface, settings);
  SearchCounts counts;
  const double weight = 1 / static_cast<double>(samples.size());
  for (const Index source : samples) {
    propagation.begin(false, distance);
    propagation.seed({surface.mesh().at_vertex(surface.original_vertex(source))}, 0);
    propagation.run(context, [] { return infinity; });
    add_windows(propagation, weight, counts);
    for (const Index v : propagation.reached())
      if (surface.kind(v) != PackedMesh::VertexKind::smooth) counts.bends += weight;
  }
  return counts;
}

SearchCounts count_direct(const PackedMesh& surface, const Settings& settings, const DirectGround& ground,
                          std::span<const Index> samples, double distance, const RunContext& context) {
  DirectSearch search(surface, settings, ground);
  SearchCounts counts;
  const double weight = 1 / static_cast<double>(samples.size());
  for (const Index source : samples) {
    counts.paths += weight * static_cast<double>(search.run(source, distance, context).size());
    counts.bounds += weight * static_cast<double>(search.direct().tried());
    add_windows(search.propagation(), weight, counts);
  }
  return counts;
}

}  // namespace geodrome::chen_han
