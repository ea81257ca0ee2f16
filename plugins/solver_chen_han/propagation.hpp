// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/vertex_propagation.hpp"
#include "plugins/solver_chen_han/apex.hpp"
#include "plugins/solver_chen_han/child.hpp"
#include "plugins/solver_chen_han/fan_windows.hpp"
#include "plugins/solver_chen_han/gathering.hpp"
#include "plugins/solver_chen_han/kept_windows.hpp"
#include "plugins/solver_chen_han/rows/direct_run.hpp"
#include "plugins/solver_chen_han/settings.hpp"
#include "plugins/solver_chen_han/trimming.hpp"
#include "plugins/solver_chen_han/wavefront.hpp"

namespace geodrome::chen_han {

struct Counts {
  std::uint64_t passes = 0;      ///< half-edges whose waiting windows were carried on, each time
  std::uint64_t created = 0;     ///< windows that came to wait at a half-edge; merging may cut one into pieces later
  std::uint64_t propagated = 0;  ///< windows carried on
  std::uint64_t filtered = 0;    ///< windows dropped because a vertex is a shorter way
  std::uint64_t trimmed = 0;     ///< windows dropped because other windows are shorter everywhere
  std::uint64_t longest = 0;     ///< the longest list carried on
};

/// Windows carried over a surface from its sources, half-edge by half-edge, nearest first (Chen and Han 1990, Xin and
/// Wang 2009, whole lists at a time as in Qin et al. 2016). All distances are those of the flat surface, and so are the
/// numbers of faces and vertices. Used again and again: a run costs what it reaches.
///
/// Why distances are exact: a window, or a part of one, is dropped only where a path that exists is shorter (trimming,
/// filter) or where it leaves the surface; so the window along a shortest path is never dropped. Why it ends: a
/// shortest path crosses no face twice, so windows deeper than the number of faces are dropped; then there are finitely
/// many paths, and a vertex emits again only for a shorter one.
class Propagation : public VertexPropagation<Propagation, Step> {
 public:
  using Settings = chen_han::Settings;

  /// The shortest way through a kept window to a point, which is at (x, y) in the frame of the window's half-edge; none
  /// as constructed.
  struct Way {
    double distance = infinity;
    Index source = no_index, window = no_index;
    double x = 0, y = 0;
  };

  Propagation(const PackedMesh& surface, const Settings& settings);

  /// Forgets the last run. With `keep` all windows that are carried on are kept.
  void begin(bool keep, double limit);
  /// The same, and starts at a vertex, for a direct run: no other vertex sends windows, and a run ends where their
  /// bounds (DirectRun) are shorter than all windows. Labels are those of direct paths, complete where one is shortest.
  /// `direct` outlives the run.
  void begin_direct(DirectRun& direct, Index source, double limit);

  /// After a run with `keep`: the shortest way through a window to a point that is no vertex, none unless it is shorter
  /// than `best`. O(windows of the face).
  Way way_to(const SurfacePoint& inner, double best) const;
  /// Appends the points of a way between the one it leads to and its source, without both, in the mesh's own numbers.
  void trace(const Way& way, std::vector<SurfacePoint>& out) const;
  /// The same from a vertex, which comes first; nothing if it is a source.
  void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const;

  /// After a run: the shortest path found to a vertex.
  const Label& label(Index vertex) const { return labels_[vertex]; }

  /// What the run took; the last is the memory.
  std::array<Counter, 8> counters() const;
  std::size_t bytes() const;

 private:
  friend VertexPropagation;

  /// Where a window has lines, seen from the apex, and the way to it.
  struct Sides {
    bool left, right;
    double way;
    bool both() const { return left && right; }
  };

  Wavefront& waiting() { return wavefront_; }
  std::uint64_t carried() const { return counts_.propagated; }
  bool ended() const { return direct_ && emissions() > 0 ? !wavefront_.has_windows() : wavefront_.empty(); }
  bool is_to_wait(Index vertex, const Label& label) {
    return direct_ ? direct_->lower(vertex, label.distance) : VertexPropagation::is_to_wait(vertex, label);
  }
  double along_edges_from(Index vertex) const {
    return direct_ && !direct_->passes(vertex) ? infinity : labels_.distance(vertex);
  }
  bool may_be_left_to(Index vertex) const { return !direct_ || direct_->goes_on(vertex); }
  void lowered_along_edge(Index vertex, Index from, double) {
    if (direct_) note_exit_along_edge(vertex, from);
  }
  double shortest_to(Index vertex) const { return direct_ ? direct_->bound(vertex) : labels_.distance(vertex); }
  /// Whether a path of this length through window i to the apex counts, if it is no way around a vertex.
  bool may_lower(const Apex& apex, const Span& list, std::size_t i, double length) const {
    return !direct_ || direct_->is_straight(length, list.windows.to(i, apex.x, apex.y));
  }
  void go_on_from(Index vertex);
  void note_exit_along_edge(Index vertex, Index from);
  void note_exit(const Apex& apex, const WindowArrays& windows, std::size_t i, double x);
  double bend_at(const WindowArrays& windows, std::size_t i, double x) const;
  void widen_if_bent_near(const Apex& apex, bool bent, double x, double distance);
  void next();
  void send_wedge(const Apex& apex, const PseudoSource& from, double to_end, Entry entry);

  void pass(Index half_edge, Span list, Index depth);
  void filter(Span& list, double length, double at_start, double at_end);
  void lower_watched(Index half_edge, const Span& list);

  void lower_apex(const Apex& apex, const Span& list, const Split& split);
  void lower_apex_over(const Apex& apex, const Span& list, std::size_t before, std::size_t after);
  void lower_apex_by(const Apex& apex, const Span& list, std::size_t window, double x, double distance);

  void carry_one_by_one(const Apex& apex, const Span& list, Index depth);
  void carry(const Apex& apex, const Child& left, const Child& right, Index depth);
  Block& carried(const Child& child, const Turn& turn, Entry entry, Index depth);
  void hand_on(Block& block, const PackedMesh::Face& face, Index edge);
  void hand_on_elsewhere(Block& block, Index edge, bool at_once);
  void hand_on_claimed(Block& block, Index edge);
  Block& claimed(const Span& windows, const Block& block, Index edge);
  void pass_at_once(Block& block, Index edge);

  Settings settings_;
  DirectRun* direct_ = nullptr;  ///< in a direct run, in which the names of windows are the Bearing of their frame
  const Lanes* lanes_;
  Wavefront wavefront_;
  WindowStore& store_;
  Trimming trimming_;
  FanWindows fans_;
  Gathering gathering_;
  KeptWindows kept_;
  WindowList chosen_left_, chosen_right_;
  std::vector<Sides> sides_;
  Counts counts_;
};

}  // namespace geodrome::chen_han
