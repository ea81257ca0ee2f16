// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/checks/invariants.hpp"
#include "geodrome/engine/named_points.hpp"

namespace geodrome {

/// `check_invariants` of distances from sources to targets: the same point is what is the same row of the input, and a
/// dropped one has no position. `read` gives the distances from a source, by its place in the list.
Invariants check_invariants(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                            std::function<std::vector<double>(std::uint64_t)> read, const InvariantOptions& options);

}  // namespace geodrome
