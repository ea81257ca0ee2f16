// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geodrome/run_context.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_chen_han/rows/direct_list.hpp"
#include "plugins/solver_chen_han/rows/direct_search.hpp"

namespace geodrome::chen_han {

/// The vertices at which a path from one of some sources can bend, however long it is: all but smooth ones. In
/// ascending order. O(V).
std::vector<Index> bends_of(const PackedMesh& surface, std::span<const Index> sources);
/// The same within a distance, by one search from all sources; nothing if it took more than `most_bytes`, as it may
/// where windows of many sources meet at a vertex of very many faces. Throws Cancelled.
std::optional<std::vector<Index>> bends_within(const PackedMesh& surface, const Settings& settings,
                                               std::span<const Index> sources, double distance, std::size_t most_bytes,
                                               const RunContext& context);

/// The direct paths from vertices at which paths can bend.
struct DirectLists {
  std::vector<DirectList> lists;  ///< by vertex; empty but for those asked for
  std::size_t bytes = 0;
};

/// Makes the lists of `vertices`, with paths up to `distance`, on up to `context.threads()` threads; nothing if they
/// take more than `most_bytes`. Throws Cancelled.
std::optional<DirectLists> make_lists(const PackedMesh& surface, const Settings& settings, const DirectGround& ground,
                                      std::span<const Index> vertices, double distance, std::size_t most_bytes,
                                      RunContext& context);

}  // namespace geodrome::chen_han
