// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "geodrome/errors.hpp"
#include "geodrome/shortest_path_map.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// The distances of a request's targets, kept after the rest is dropped (Keep::targets). Reused from run to run. Not to
/// be changed by two threads at once; reading is thread-safe.
class KeptTargets {
  using Entry = std::pair<SurfacePoint, Distance>;
  static auto key(const SurfacePoint& p) { return std::tuple(p.face, p.b[0], p.b[1], p.b[2]); }

 public:
  void clear() { entries_.clear(); }

  /// Replaces what is kept by `distance_of(point)`, a Distance, of each of `targets`. O(t log t) for t targets.
  template <class Function>
  void assign(std::span<const SurfacePoint> targets, Function&& distance_of) {
    entries_.clear();
    for (const SurfacePoint& target : targets) entries_.emplace_back(target, distance_of(target));
    std::sort(entries_.begin(), entries_.end(),
              [](const Entry& a, const Entry& b) { return key(a.first) < key(b.first); });
  }

  /// Returns the kept distance of a target, named as in the request. Throws CapabilityError for any other point.
  /// O(log t).
  const Distance& at(const SurfacePoint& point) const {
    const auto found = std::lower_bound(entries_.begin(), entries_.end(), point,
                                        [](const Entry& a, const SurfacePoint& b) { return key(a.first) < key(b); });
    if (found == entries_.end() || found->first != point)
      throw CapabilityError("only vertices and the targets were kept", "request Keep::map");
    return found->second;
  }

 private:
  std::vector<Entry> entries_;
};

}  // namespace geodrome
