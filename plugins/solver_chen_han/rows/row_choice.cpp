// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/row_choice.hpp"

#include <algorithm>
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

}  // namespace

std::vector<Index> samples(std::span<const Index> sources) {
  constexpr std::size_t most = 8, one_in = 256;
  const std::size_t count = std::clamp<std::size_t>(sources.size() / one_in, 1, most);
  std::vector<Index> chosen;
  for (std::size_t i = 0; i < count; ++i) chosen.push_back(sources[(2 * i + 1) * sources.size() / (2 * count)]);
  return chosen;
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
