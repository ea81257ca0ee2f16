// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/direct_lists.hpp"

#include <algorithm>
#include <atomic>

#include "interfaces/internal/shared_work.hpp"

namespace geodrome::chen_han {

namespace {

bool can_bend(const PackedMesh& surface, Index vertex) {
  return surface.kind(vertex) != PackedMesh::VertexKind::smooth && !surface.corners(vertex).empty();
}

}  // namespace

std::vector<Index> bends_of(const PackedMesh& surface, std::span<const Index> sources) {
  const auto component = [&](Index v) { return surface.components()[surface.original_vertex(v)]; };
  std::vector<bool> with_source(surface.vertex_count());
  for (const Index source : sources) with_source[component(source)] = true;
  std::vector<Index> vertices;
  for (Index v = 0; v < surface.vertex_count(); ++v)
    if (can_bend(surface, v) && with_source[component(v)]) vertices.push_back(v);
  return vertices;
}

std::optional<std::vector<Index>> bends_within(const PackedMesh& surface, const Settings& settings,
                                               std::span<const Index> sources, double distance, std::size_t most_bytes,
                                               const RunContext& context) {
  Propagation propagation(surface, settings);
  propagation.begin(false, distance);
  most_bytes += propagation.bytes();
  for (const Index source : sources) propagation.seed({surface.mesh().at_vertex(surface.original_vertex(source))}, 0);
  bool too_large = false;
  propagation.run(context, [&] {
    too_large = too_large || propagation.bytes() > most_bytes;
    return too_large ? 0.0 : infinity;
  });
  if (too_large) return std::nullopt;
  std::vector<Index> vertices;
  for (const Index v : propagation.reached())
    if (can_bend(surface, v) && propagation.answer(v).distance <= distance) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::optional<DirectLists> make_lists(const PackedMesh& surface, const Settings& settings, const DirectGround& ground,
                                      std::span<const Index> vertices, double distance, std::size_t most_bytes,
                                      RunContext& context) {
  DirectLists result{std::vector<DirectList>(surface.vertex_count()), 0};
  std::atomic<std::size_t> bytes = result.lists.size() * sizeof(DirectList), done = 0;
  share_work(vertices.size(), 16, context.threads(), context, [&] {
    return [&, search = DirectSearch(surface, settings, ground)](std::uint64_t begin, std::uint64_t end) mutable {
      for (std::uint64_t i = begin; i < end && bytes <= most_bytes; ++i) {
        DirectList list = search.list(vertices[i], distance, context);
        bytes += list.bytes();
        result.lists[vertices[i]] = std::move(list);
      }
      context.progress(static_cast<double>(done += end - begin) / static_cast<double>(vertices.size()));
    };
  });
  if (bytes > most_bytes) return std::nullopt;
  share_work(vertices.size(), 16, context.threads(), context, [&] {
    return [&](std::uint64_t begin, std::uint64_t end) {
      for (std::uint64_t i = begin; i < end; ++i) result.lists[vertices[i]].complete(result.lists);
    };
  });
  result.bytes = bytes;
  return result;
}

}  // namespace geodrome::chen_han
