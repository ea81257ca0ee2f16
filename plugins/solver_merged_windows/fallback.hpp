// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "plugins/solver_chen_han/propagation.hpp"
#include "plugins/solver_merged_windows/propagation.hpp"

namespace geodrome::merged_windows {

/// Merged windows, or, in a run whose lists stay long, exact windows: these carry long lists faster. Which of the two a
/// run is made with depends on that run alone. A MeshPropagation (plugins/common/exact/propagation.hpp).
class Fallback {
 public:
  using Settings = merged_windows::Settings;
  using Exact = chen_han::Propagation;
  static constexpr std::size_t steps_a_poll = Propagation::steps_a_poll;

  /// A way of the one that the run was made with.
  struct Way {
    double distance = infinity;
    Index source = no_index;
    Propagation::Way merged;
    Exact::Way exact;
  };

  Fallback(const PackedMesh& surface, const Settings& settings)
      : surface_(surface),
        delta_(settings.delta),
        has_few_faces_(std::pow(surface.face_count(), 1.5) * settings.delta < settings.few_faces),
        merged_(surface, settings) {}

  void begin(bool keep, double limit);
  void seed(const Source& source, Index number);
  std::vector<Watched>& watched() { return is_exact_ ? exact_->watched() : merged_.watched(); }
  const std::vector<Watched>& watched() const { return is_exact_ ? exact_->watched() : merged_.watched(); }

  template <class LowerLimit>
  void run(const RunContext& context, LowerLimit&& lower_limit) {
    try {
      if (!has_few_faces_) return merged_.run(context, lower_limit);
    } catch (const MergingFails&) {
    }
    begin_exact();
    exact_->run(context, lower_limit);
  }

  FoundDistance answer(Index vertex) const { return is_exact_ ? exact_->answer(vertex) : merged_.answer(vertex); }
  const std::vector<Index>& reached() const { return is_exact_ ? exact_->reached() : merged_.reached(); }
  /// l of a vertex: no path to it is shorter. Infinite where nothing was found below the limit.
  double lower_bound(Index vertex) const {
    return is_exact_ ? exact_->answer(vertex).distance : merged_.lower_bound(vertex);
  }
  /// The factor that all distances of this run keep, also at points in faces.
  double factor() const { return is_exact_ ? 1 : 1 + delta_; }
  Way way_to(const SurfacePoint& inner, double best) const;
  void trace(const Way& way, std::vector<SurfacePoint>& out) const;
  void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const;

  /// Those of merged windows, or what the exact ones count under the same names. The last is the memory.
  std::array<Counter, 10> counters() const;

 private:
  void begin_exact();

  const PackedMesh& surface_;
  double delta_;
  bool has_few_faces_;
  Propagation merged_;
  std::optional<Exact> exact_;  ///< made when it is needed first
  bool is_exact_ = false, keep_ = false;
  double limit_ = 0;
  std::vector<std::pair<Source, Index>> seeds_;
};

}  // namespace geodrome::merged_windows
