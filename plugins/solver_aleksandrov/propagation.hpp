// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "plugins/common/exact/found_distance.hpp"
#include "plugins/common/exact/watched_target.hpp"
#include "plugins/solver_aleksandrov/direct_way.hpp"
#include "plugins/solver_aleksandrov/discretization.hpp"
#include "plugins/solver_aleksandrov/graph_search.hpp"
#include "plugins/solver_aleksandrov/traced_path.hpp"

namespace geodrome::aleksandrov {

/// A search over the Steiner graph from any places of a surface, in the form that PropagationSearch asks for. All
/// distances are those of the flat surface. Used again and again: a run costs what it reaches.
class Propagation {
 public:
  using Settings = std::shared_ptr<const Discretization>;
  static constexpr std::size_t steps_a_poll = GraphSearch::steps_a_poll;

  /// The shortest way to a place: from a node, or straight from a start, or one around a source vertex made smaller.
  struct Way {
    double distance = infinity;
    Index source = no_index;
    Index node = no_index, start = no_index;
    SurfacePoint at;    ///< the place, in a face of the graph's triangulation; where the way is made smaller, its end
    SurfacePoint flat;  ///< the place, in a face of the flat surface
    Index around = no_index;  ///< a source vertex: the way is one to `at`, made smaller by `scale` towards it
    double scale = 1;
  };

  Propagation(const PackedMesh& surface, const Settings& discretization);

  void begin(bool keep, double limit);
  void seed(const Source& source, Index number);
  std::vector<Watched>& watched() { return watched_; }
  const std::vector<Watched>& watched() const { return watched_; }

  template <class LowerLimit>
  void run(const RunContext& context, LowerLimit&& lower_limit) {
    std::sort(starts_at_.begin(), starts_at_.end());
    std::size_t polls = 0;  // looking at watched points must cost less than the search
    search_.run(context, limit_ + margin_, [&] {
      if (++polls % (1 + watched_.size() / 64) == 0) look_at_watched();
      return lower_limit() + margin_;
    });
    finish();
  }

  FoundDistance answer(Index vertex) const {
    return {search_.labels().distance(vertex), search_.labels().source(vertex)};
  }
  const std::vector<Index>& reached() const { return reached_; }

  Way way_to(const SurfacePoint& inner, double best) const;
  void trace(const Way& way, std::vector<SurfacePoint>& out) const;
  void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const;

  std::array<Counter, 5> counters() const;

 private:
  /// A source that is no vertex, by one of its names in the graph's triangulation.
  struct Start {
    SurfacePoint at;
    double distance;
    Index source;
    SurfacePoint flat;  ///< in the flat surface
  };

  const SteinerGraph& graph() const { return discretization_->graph(); }
  std::vector<Index> starts_near(const SurfacePoint& at) const;
  void look_at_watched();
  void through_nodes(const SurfacePoint& name, Way& way) const;
  void straight(const SurfacePoint& name, Way& way) const;
  void around_sources(const SurfacePoint& name, Way& way) const;
  void around_source(const SurfacePoint& name, Index i, Way& way) const;
  SurfacePoint trace_nodes(Index node, TracedPath& path) const;
  void finish();

  Settings discretization_;
  GraphSearch search_;
  std::vector<Index> reached_;
  std::vector<Start> starts_;
  std::vector<std::pair<Index, Index>> starts_at_;  ///< (vertex of its face, start), ascending in a run
  std::vector<Watched> watched_;
  double limit_ = 0;
  double margin_ = 0;  ///< so far beyond a place near a source vertex on a weighted surface its way is looked for
};

}  // namespace geodrome::aleksandrov
