// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>

#include "engine/smooth/smooth_metric.hpp"
#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A solver's plugin with a surface prepared: stage 5 made ready. Copies share both.
struct PreparedSolver {
  Plugin<ShortestPathSolver> plugin;
  std::shared_ptr<const PreparedSurface> prepared;
  StageRecord record;
  std::shared_ptr<const SmoothMetric> smooth;  ///< what rows, nearest sources and paths end up on; null: the triangles

  bool provides(Provides bit) const { return has(plugin.info.provides, bit); }

  // At vertices every solver does all of these; off them it states which.
  bool takes_source_at(const Place& place) const { return at_vertex_or(place, Provides::face_sources); }
  bool answers_at(const Place& place) const { return at_vertex_or(place, Provides::any_point); }
  /// The factor, if the solver states one, holds for distances from and to the place.
  bool states_factor_at(const Place& place) const { return at_vertex_or(place, Provides::factor_any_point); }

 private:
  bool at_vertex_or(const Place& place, Provides bit) const { return place.vertex != no_index || provides(bit); }
};

/// Throws CapabilityError, naming plugin and capability, if the solver does not provide all of `wanted`.
void demand(const PluginInfo& solver, Provides wanted);

/// The names of the host's solvers that provide `wanted`, joined by ", "; empty if none does. Tries every plugin, which
/// takes seconds at worst.
std::string solvers_with(Provides wanted, const PluginHost& host);

/// Prepares `mesh`. Throws CapabilityError, naming what is missing, if the mesh lacks what the solver needs, or has
/// weights that the solver does not provide; PluginError if the plugin prepares nothing; what the plugin throws.
PreparedSolver prepare_solver(Plugin<ShortestPathSolver> plugin, const MeshPtr& mesh, const PluginHost& host,
                              const RunSettings& settings, Observer& observer);

/// What smooth distances on a surface are measured on; null if they are flat there. O(V + F).
std::shared_ptr<const SmoothMetric> metric_of(const PlacedSurface& surface);

/// Moves the places of rows that are no vertices to where the smooth surface is closest to them (`settle`).
void settle_places(PlacedSurface& surface);

/// The solver with another surface prepared, flat, by the same plugin, whose needs are not checked again.
PreparedSolver prepared_on(const PreparedSolver& solver, const MeshPtr& mesh, RunContext& context);

/// A new search of the prepared surface.
std::unique_ptr<Search> make_search(const PreparedSolver& solver);

/// Runs a search across the border to the plugin.
const ShortestPathMap& run_search(const PreparedSolver& solver, Search& search, std::span<const Source> sources,
                                  const Request& request, RunContext& context);

}  // namespace geodrome
