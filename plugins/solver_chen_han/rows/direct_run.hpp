// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plugins/common/mesh/for_listed_or_all.hpp"
#include "plugins/solver_chen_han/rows/corner_angles.hpp"
#include "plugins/solver_chen_han/rows/near_lists.hpp"
#include "plugins/solver_chen_han/windows.hpp"

namespace geodrome::chen_han {

/// What a propagation knows in a run from one vertex in which no other vertex sends windows: for every vertex an upper
/// bound of its distance, which stands in for the windows that others would have sent, and the direction in which the
/// direct path to it leaves the source. Reused from run to run.
class DirectRun {
 public:
  DirectRun(const PackedMesh& surface, const NearLists& near, const CornerAngles& angles)
      : surface_(surface),
        near_(near),
        angles_(angles),
        bounds_(surface.vertex_count()),
        exits_(surface.vertex_count()) {}

  /// Forgets the last run. O(what it touched).
  void reset(Index source) {
    for_listed_or_all(touched_, bounds_.size(), [this](Index v) { bounds_[v] = {}; });
    touched_.clear();
    source_ = source;
    tried_ = 0;
  }

  Index source() const { return source_; }
  /// Returns how many paths over vertices were tried for bounds in this run.
  std::uint64_t tried() const { return tried_; }
  /// Returns the length of a path to a vertex, the shortest of those known.
  double bound(Index vertex) const { return bounds_[vertex].length; }
  /// Notes the length of a path; tells whether it is so much shorter than those known that the paths over the vertex
  /// are to be noted too. Where it is hardly shorter they stay, a little too long.
  bool lower(Index vertex, double length) {
    Bound& bound = bounds_[vertex];
    if (!(length < bound.length)) return false;
    if (bound.length == infinity) touched_.push_back(vertex);
    bound.length = length;
    if (!(length < bound.passed_on * (1 - hardly_shorter))) return false;
    bound.passed_on = length;
    return true;
  }
  /// Lowers the vertices near one by the paths over it; calls `visit(vertex, length)` for those that were lowered.
  template <class Visit>
  void lower_near(Index vertex, Visit&& visit) {
    const double bound = bounds_[vertex].length;
    tried_ += near_[vertex].size();
    for (const NearLists::Entry& entry : near_[vertex])
      if (lower(entry.vertex, bound + entry.length)) visit(entry.vertex, bound + entry.length);
  }

  /// Tells whether a direct path may go on from a vertex along an edge: not where paths can bend, for it would count as
  /// one that bends there.
  bool passes(Index vertex) const {
    return vertex == source_ || surface_.kind(vertex) == PackedMesh::VertexKind::smooth;
  }
  /// Tells whether paths go on from a vertex to all sides, here or by its own list.
  bool goes_on(Index vertex) const {
    return vertex == source_ || surface_.kind(vertex) != PackedMesh::VertexKind::smooth;
  }
  /// Tells whether a path that bends at the end of a window is straight but for rounding, and no way around a vertex.
  static bool is_straight(double length, double straight) { return length <= straight * (1 + 1e-6); }

  /// Returns the direction in which the direct path to a vertex leaves the source. Precondition: there is one.
  Bearing exit(Index vertex) const { return exits_[vertex]; }
  void set_exit(Index vertex, Bearing bearing) { exits_[vertex] = bearing; }
  /// Returns the direction in which the edge from the source to a vertex leaves it. O(degree of the vertex): all
  /// neighbours of a source of very many faces are asked about.
  Bearing exit_along_edge(Index vertex) const {
    for (const Index corner : surface_.corners(vertex)) {
      const Index next = SurfaceMesh::next(corner), previous = SurfaceMesh::previous(corner);
      if (surface_.from(previous) == source_) return angles_.start(previous);
      if (surface_.from(next) == source_) return angles_.start(next) + angles_.angle(next);
    }
    return unknown_bearing;
  }

  /// Returns the bearing of the frame beyond the edge opposite the source in the face of `corner`, which starts there.
  Bearing first_bearing(Index corner) const { return angles_.start(corner) - angles_.angle(SurfaceMesh::next(corner)); }
  /// Returns the direction of the ray (dx, dy), dy >= 0, in a frame with this bearing.
  static Bearing direction(Bearing frame, double dx, double dy) { return frame + bearing_of(std::atan2(dy, dx)); }
  /// Returns the angle of a corner.
  Bearing angle(Index corner) const { return angles_.angle(corner); }

  /// All windows come from one vertex, so both their names together hold the bearing of their frame; that of a mirrored
  /// window is made unknown by a bit of `parent`, the lower half.
  static Bearing bearing(const WindowArrays::Names& names) { return Bearing{names.origin} << 32 | names.parent; }
  static WindowArrays::Names names(Bearing bearing) {
    return {static_cast<Index>(bearing >> 32), static_cast<Index>(bearing)};
  }
  /// Turns the frames of windows by an angle.
  static void turn(const Span& list, Bearing angle) {
    WindowArrays::Names* const all = list.windows.names();
    for (std::size_t i = 0; i < list.count; ++i) all[i] = names(bearing(all[i]) + angle);
  }

  std::size_t bytes() const {
    return bounds_.size() * sizeof(Bound) + exits_.size() * sizeof(Bearing) + touched_.capacity() * sizeof(Index);
  }

 private:
  static constexpr double hardly_shorter = 0.01;

  struct Bound {
    double length = infinity;
    double passed_on = infinity;  ///< the length when paths over the vertex were last to be noted
  };

  const PackedMesh& surface_;
  const NearLists& near_;
  const CornerAngles& angles_;
  std::vector<Bound> bounds_;
  std::vector<Bearing> exits_;
  std::vector<Index> touched_;
  Index source_ = no_index;
  std::uint64_t tried_ = 0;
};

}  // namespace geodrome::chen_han
