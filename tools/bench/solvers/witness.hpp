// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <memory>
#include <span>
#include <vector>

#include "engine/surface/common_face.hpp"
#include "geodrome/engine/audit.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::bench {

/// Cancels what runs longer than the limit, so that a solver that hangs is told from one that answers.
class DeadlineContext final : public QuietContext {
 public:
  using Clock = std::chrono::steady_clock;

  explicit DeadlineContext(double seconds) : limit_(seconds) { restart(); }
  void restart() {
    end_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit_));
  }
  bool cancelled() const noexcept override { return Clock::now() > end_; }

 private:
  double limit_;
  Clock::time_point end_;
};

/// A solver on a mesh whose answers are checked: its distances, and the lengths of the paths it claims, which are added
/// up here. Throws what the solver throws, Cancelled if a run takes longer than `seconds`.
class Witness {
 public:
  /// Throws CapabilityError if the mesh lacks what the solver needs.
  Witness(const Plugin<ShortestPathSolver>& plugin, MeshPtr mesh, double seconds);

  void run(std::span<const Source> sources, const Request& request);

  /// Of the last run: distances at points, at all vertices, +inf where not reached.
  std::vector<double> at(std::span<const SurfacePoint> points) const;
  std::span<const double> vertices() const { return map_->vertices(); }
  std::span<const Counter> counters() const { return map_->counters(); }

  /// The length of the path from a point to its source, plus the source's start distance; what the ends of the path
  /// miss the two by is added. +inf if there is no path or if it leaves the surface. Needs Keep::map.
  double path_length(const SurfacePoint& from) const;

  /// The engine's audit of a share of the faces.
  AuditResult audited(double share, std::uint64_t seed) const;

  const SurfaceMesh& mesh() const { return *mesh_; }
  bool provides(Provides bits) const { return has(plugin_.info.provides, bits); }

 private:
  Plugin<ShortestPathSolver> plugin_;
  MeshPtr mesh_;
  CommonFace common_;
  DeadlineContext context_;
  std::unique_ptr<PreparedSurface> prepared_;
  std::unique_ptr<Search> search_;
  std::vector<Source> sources_;
  const ShortestPathMap* map_ = nullptr;
};

}  // namespace geodrome::bench
