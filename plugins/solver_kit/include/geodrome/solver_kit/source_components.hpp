// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "geodrome/surface.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome {

/// The components that hold a source of the current run: they tell unreachable points from those beyond a limit. Reused
/// from run to run. Complexity: O(s log s) to assign s sources, O(log s) to ask.
class SourceComponents {
 public:
  template <class Sources>
  void assign(const SurfaceMesh& mesh, const std::vector<Index>& component, const Sources& sources) {
    ids_.clear();
    for (const auto& source : sources) ids_.push_back(component[mesh.triangles()[source.at.face][0]]);
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
  }
  bool contains(Index component) const { return std::binary_search(ids_.begin(), ids_.end(), component); }

 private:
  std::vector<Index> ids_;
};

}  // namespace geodrome
