// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/fan_envelope.hpp"
#include "plugins/common/exact/vertex_propagation.hpp"
#include "plugins/solver_merged_windows/kept_windows.hpp"
#include "plugins/solver_merged_windows/merging.hpp"
#include "plugins/solver_merged_windows/pair.hpp"
#include "plugins/solver_merged_windows/settings.hpp"
#include "plugins/solver_merged_windows/trimming.hpp"
#include "plugins/solver_merged_windows/upper_bounds.hpp"
#include "plugins/solver_merged_windows/wavefront.hpp"

namespace geodrome::merged_windows {

struct Counts {
  std::uint64_t passes = 0;      ///< half-edges whose waiting windows were carried on, each time
  std::uint64_t created = 0;     ///< windows that came to wait at a half-edge
  std::uint64_t propagated = 0;  ///< windows carried on
  std::uint64_t filtered = 0;    ///< windows dropped because a vertex is a shorter way
  std::uint64_t longest = 0;     ///< the longest list carried on
};

/// Thrown by a run in which so few windows merge that exact ones are faster.
struct MergingFails {};

/// What labels take for a step of their paths; none are kept (upper_bounds.hpp has those of D).
struct LabelStep {
  Index vertex = no_index;
};

/// Windows carried over a surface from its sources, half-edge by half-edge, nearest first, and merged where that costs
/// little. The labels of vertices are l, the least L of all windows; what is answered is D, the length of the shortest
/// path found. PROOF.md proves l <= d <= D <= (1 + delta) l. Distances, faces and vertices are those of the packed
/// mesh. Used again and again: a run costs what it reaches.
class Propagation : public VertexPropagation<Propagation, LabelStep> {
 public:
  using Settings = merged_windows::Settings;

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

  /// D of a vertex.
  FoundDistance answer(Index vertex) const { return upper_[vertex]; }
  /// l of a vertex: no path to it is shorter. Infinite where nothing was found below the limit.
  double lower_bound(Index vertex) const { return labels_.distance(vertex); }

  /// After a run with `keep`: the shortest way through a window to a point that is no vertex, none unless it is shorter
  /// than `best`. O(windows of the face).
  Way way_to(const SurfacePoint& inner, double best) const;
  /// Appends the points of a way between the one it leads to and its source, without both, in the mesh's own numbers.
  void trace(const Way& way, std::vector<SurfacePoint>& out) const;
  /// The same from a vertex, which comes first; nothing if it is a source.
  void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const;

  /// What the run took; the last is the memory.
  std::array<Counter, 10> counters() const;
  std::size_t bytes() const;

 private:
  friend VertexPropagation;

  /// How a list meets the apex: windows [0, left_end) have lines to its left, [right_begin, end) to its right, if it is
  /// `in_order`. Windows in both have lines to it; `best` is the lowest of them, and those of [first_best, last_best)
  /// are as low up to rounding.
  struct Split {
    std::size_t right_begin, left_end, best, first_best, last_best;
    bool in_order;
    bool covered() const { return right_begin < left_end; }
  };

  Wavefront& waiting() { return wavefront_; }
  std::uint64_t carried() const { return counts_.propagated; }
  void polled() const;
  void next();
  void send_wedge(const Apex& apex, const PseudoSource& from, double to_end, Entry entry);
  void lowered_along_edge(Index vertex, Index from, double length);
  void lowered_straight(Index vertex, double distance, Index source);
  void lowered_at_source(Index vertex, double distance, Index source);

  void process(Index half_edge, Index window);
  void gather(Index window);
  void keep_nearest(Index half_edge);
  void list_pieces(std::span<const Window> windows);
  void list_parts(std::span<const Window> windows);
  void pass(Index half_edge);
  void filter(const Apex& apex);
  double sine_below(Index half_edge) const;
  void merge(const Apex& apex);
  void keep_carried();
  void lower_watched(Index half_edge);

  bool process_two(Index half_edge, Index first, Index second);
  void pass_two(Index half_edge, std::array<Window, 2>& windows);
  void cross_two(const Apex& apex, const Window& left, const Window& right, const Pair& pair);
  void send_two(Index left, Index right, const Apex& apex, int i);

  void pass_alone(Index half_edge, const Window& window);
  bool is_needless(const Window& window, const Apex& apex) const;
  void cross_alone(const Apex& apex, const Window& window);
  void cross(const Apex& apex);
  Split split_at(const Apex& apex) const;
  void lower_apex(const Apex& apex, const Split& split);
  void lower_apex_straight(const Apex& apex, const Window& window);
  void lower_apex_bent(const Apex& apex, const Window& window, double x);
  void lower_apex_by(const Apex& apex, const Window& window, double x, double value);
  bool may_join(const Window& a, const Window& b) const;

  void carry_one_by_one(const Apex& apex);
  void carry_left(const Apex& apex, std::span<const Window> windows, std::size_t clipped);
  void carry_right(const Apex& apex, std::span<const Window> windows, std::size_t clipped);
  void carry_left(const Apex& apex, const Window& window, bool clipped, Window& child) const;
  void carry_right(const Apex& apex, const Window& window, bool clipped, Window& child) const;
  void send_left(const Apex& apex, const Window& window, bool clipped);
  void send_right(const Apex& apex, const Window& window, bool clipped);
  void enter(Window& window, Entry entry) const;
  void send(Index edge);
  void hand_on_alone(Index child, const Apex& apex, int i);
  void hand_on(std::span<const Window> run, Index edge);

  Settings settings_;
  Wavefront wavefront_;
  Trimming trimming_;
  Merging merging_;
  UpperBounds upper_;
  FanEnvelope fans_;
  KeptWindows kept_;
  std::uint32_t deepest_merge_;  ///< F of the proof
  WindowList list_, child_, chosen_;
  WindowList gathered_, parts_;
  std::vector<std::size_t> ends_;  ///< of runs in gathered_
  EdgePieces pieces_;
  Counts counts_;
};

}  // namespace geodrome::merged_windows
