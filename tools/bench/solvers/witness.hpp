// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/surface/common_face.hpp"
#include "geodrome/engine/audit.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/lower_bounds.hpp"
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

/// A path, as its steps add up, plus the start distance of its source; and what its ends miss of the point that was
/// asked for and of the source. Both +inf if there is no path or if it leaves the surface.
struct MeasuredPath {
  double length = std::numeric_limits<double>::infinity(), miss = length;
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
  /// Likewise what the solver states by the extension LowerBounds: what the distances are at least. Precondition:
  /// `states_bounds`.
  std::vector<double> lower_bounds(std::span<const SurfacePoint> points) const;
  std::span<const double> vertices() const { return map_->vertices(); }
  std::span<const Counter> counters() const { return map_->counters(); }

  /// The path from a point to its source as the solver gives it, empty if not reached. Needs Keep::map.
  std::vector<SurfacePoint> traced(const SurfacePoint& from) const;
  /// How long it is.
  MeasuredPath path(const SurfacePoint& from) const;
  /// Its length and what its ends miss.
  double path_length(const SurfacePoint& from) const {
    const MeasuredPath measured = path(from);
    return measured.length + measured.miss;
  }

  /// The engine's audit of a share of the faces.
  AuditResult audited(double share, std::uint64_t seed) const;

  const SurfaceMesh& mesh() const { return *mesh_; }
  bool provides(Provides bits) const { return has(plugin_.info.provides, bits); }
  bool states_bounds() const { return plugin_.extension<LowerBounds>() != nullptr; }

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
