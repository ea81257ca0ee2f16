// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/common/exact/vertex_propagation.hpp"
#include "plugins/solver_schreiber/fan_fronts.hpp"
#include "plugins/solver_schreiber/front.hpp"
#include "plugins/solver_schreiber/kept_fronts.hpp"
#include "plugins/solver_schreiber/path_tracer.hpp"
#include "plugins/solver_schreiber/waiting_fronts.hpp"

namespace geodrome::schreiber {

struct Settings {};

struct Counts {
  std::uint64_t passes = 0;    ///< fronts carried across a face
  std::uint64_t repeated = 0;  ///< of these, through a half-edge that had been passed before
  std::uint64_t most = 0;      ///< passes of one half-edge
  std::uint64_t carried = 0;   ///< generators of all fronts carried
  std::uint64_t longest = 0;   ///< generators of one front
  std::uint64_t tangled = 0;   ///< fronts whose generators were carried one by one
};

/// Carries whole wavefronts over a surface from its sources, half-edge by half-edge, nearest first (Schreiber 2010).
/// All distances are those of the packed mesh, and so are the numbers of faces and vertices. One object serves any
/// number of runs; a run costs what it reaches.
///
/// Distances are exact: the rays of a generator that count are straight paths that exist, so none is too short; a
/// generator, or the part of its wedge on one side of a vertex, is dropped only by the lemma of ordered neighbours
/// (ordered_pair.hpp) or where a path over a vertex is shorter, so the shortest path is never dropped. A run ends: a
/// shortest path crosses no face twice, so a front that has crossed as many faces as there are goes no farther; that
/// leaves finitely many paths, and a vertex emits again only for a shorter one.
///
/// The members are in propagation.cpp, but for what happens at an apex (at_apex.cpp) and after a run (ways.cpp).
class Propagation : public VertexPropagation<Propagation, Step> {
 public:
  using Settings = schreiber::Settings;
  using Way = KeptFronts::Way;

  Propagation(const PackedMesh& surface, const Settings& settings);

  /// Forgets the last run. All fronts that are carried on are kept if `keep` is true.
  void begin(bool keep, double limit);

  Way way_to(const SurfacePoint& inner, double best) const;
  void trace(const Way& way, std::vector<SurfacePoint>& out) const;
  void trace_from_vertex(Index vertex, std::vector<SurfacePoint>& out) const;

  std::array<Counter, 13> counters() const;
  std::size_t bytes() const;

 private:
  friend VertexPropagation;

  WaitingFronts& waiting() { return waiting_; }
  std::uint64_t carried() const { return counts_.carried; }
  void next();
  void send_wedge(const Apex& apex, const PseudoSource& from, double to_end, Entry entry);
  void seed_face(const SurfacePoint& at, const Source& source, Index number);

  void process(Index half_edge);
  void unite(Arrival& all, Arrival arrival, double length);
  void pass(Index half_edge, Front front, Ends ends, Course course);
  void filter(Front& front, Ends& ends, double length, double at_start, double at_end);
  void lower_watched(Index half_edge, const Front& front, double until);
  void count_pass(Index half_edge, std::size_t generators);

  struct Split {
    std::size_t left_end, right_begin;  ///< generators [0, left_end) go on to the left, [right_begin, end) to the right
    bool covered;                       ///< those in both have the apex
    bool in_order;
  };
  Split split_at(const Apex& apex, Front& front, double until);
  static Split around(const Generator& g, std::size_t best, const Front& front, const Apex& apex);
  void lower_apex(const Apex& apex, const Front& front, const Split& split);
  void lower_apex_by(const Apex& apex, const Generator& g, double x, double distance);
  void lower_apex_bent(const Apex& apex, const Generator& g);

  void carry_on(const Apex& apex, Front front, const Split& split, const Course& course, double until);
  void carry_one_by_one(const Apex& apex, const Front& front, const Course& course, double until);
  void carry(const Apex& apex, Front front, bool to_left, Course course, double until);
  void hand_on(Front front, Ends ends, Index edge, Entry entry, const Course& course);

  FrontPool pool_;
  FrontEditor editor_;
  FanFronts fans_;
  WaitingFronts waiting_;
  KeptFronts kept_;
  std::vector<SeededFace> sources_;
  std::vector<Arrival> arrivals_;
  std::vector<std::uint8_t> times_passed_;  ///< of each half-edge, up to 255
  std::vector<Index> passed_;               ///< half-edges with a number above 0
  Counts counts_;
  std::uint64_t nodes_before_ = 0;
};

}  // namespace geodrome::schreiber
