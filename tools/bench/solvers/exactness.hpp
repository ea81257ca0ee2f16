// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

/// Whether a solver is exact on a mesh: by a peer, by the paths it traces, by the audit, and by itself.
namespace geodrome::bench {

/// What "exact" means here, relative to the largest distance from the source: for distances and lengths of paths, and
/// for the audit, whose Lipschitz bound adds up the rounding of two distances and of coordinates.
inline constexpr double value_limit = 1e-12, audit_limit = 1e-11;

/// What distances are compared by: the largest that is finite; 1 if none is above 0.
double largest_finite(std::span<const double> values);

/// The worst of both; a figure that is not a number is the worst one.
void raise(double& worst, double figure);

struct ExactnessOptions {
  std::size_t sources = 3;   ///< in turn at a vertex, inside a face, on an edge
  std::size_t points = 300;  ///< inside faces
  std::uint64_t seed = 1;    ///< chooses both
  double seconds = 600;      ///< a search that takes longer is given up
  double share = 1;          ///< of the faces that are audited and of the places whose paths are measured; above 0
};

/// The worst of all sources. Figures are relative to the largest distance from the source, but for `relative`. Where
/// solver and peer differ by more than value_limit, the shorter one is right if its value is the length of a path on
/// the surface; the path is traced and measured to tell. `at_vertices`, `at_points` and `relative` leave out the places
/// where the peer was proven wrong so.
struct Exactness {
  double at_vertices = 0, at_points = 0;  ///< largest |D - D_peer|
  double relative = 0;                    ///< largest |D - D_peer| / D_peer, at both; never judged
  double paths = 0;                       ///< largest |length of the path - D|, at vertices and points
  double together = 0;  ///< all sources at once, with start distances, against the least of the single runs
  double scaled = 0;    ///< runs that keep only targets, on the mesh times 1, 1e-6 and 1e6, against D
  double lipschitz = 0, audit_paths = 0;  ///< what the engine's audit of the faces found

  std::size_t peer_wrong = 0, solver_wrong = 0;  ///< places
  double peer_error = 0;                         ///< the largest error of the peer that was proven
  std::string peer_silent;                       ///< why the peer did not judge; empty if it did, from every source
  std::string where;                             ///< the worst place of the audit, for people
  std::string failure;                           ///< what the solver threw, or answered against the contract

  /// Whether nothing is beyond its limit. NaN is.
  bool exact() const;
};

/// Judges `solver` on a mesh; without a peer (null), or where the peer cannot take the mesh or throws, by the rest
/// alone. A solver that throws is a failure in the result; only what is no fault of the solver is thrown.
Exactness judge(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>* peer, const MeshPtr& mesh,
                const ExactnessOptions& options);

/// Judges `solver` on `refined`, a finer mesh of the same surface (refine.hpp), by the peer on the coarse one: sources
/// and places are the coarse mesh's vertices, which both number alike. `options.points` does not count.
Exactness judge_refined(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>* peer,
                        const MeshPtr& coarse, const MeshPtr& refined, const ExactnessOptions& options);

/// The peer of a selection; nothing for "none".
inline std::optional<Plugin<ShortestPathSolver>> load_peer(const PluginHost& host, const std::string& selection) {
  if (selection == "none") return std::nullopt;
  return host.load<ShortestPathSolver>(selection);
}

/// One line of figures under the line of their names, in columns.
std::string exactness_names();
std::string exactness_figures(const Exactness& result);
/// What figures cannot say: empty, or lines that end with a line break.
std::string exactness_notes(const Exactness& result);

}  // namespace geodrome::bench
