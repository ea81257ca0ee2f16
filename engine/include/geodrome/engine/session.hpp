// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/distances.hpp"
#include "geodrome/engine/input.hpp"
#include "geodrome/engine/jobs.hpp"
#include "geodrome/engine/named_points.hpp"
#include "geodrome/engine/observer.hpp"
#include "geodrome/engine/pipeline.hpp"
#include "geodrome/engine/row_set.hpp"
#include "geodrome/engine/row_sink.hpp"
#include "geodrome/engine/surface_report.hpp"

namespace geodrome {

/// An observer that hears nothing and never cancels; of the whole process.
Observer& silent_observer() noexcept;

/// An input with its surface, and distances on it in memory: what the jobs do, without their files. Units are those of
/// the input, indices count from 0, distances are +inf for unreachable and beyond the limit, NaN for a row that was
/// dropped or is off the part (`RunSettings::part`).
///
/// The surface is made at once, the solver prepares it with the first question and stays prepared. Every const member
/// may be called from several threads at once; each uses `RunSettings::threads` threads where it says so, and no
/// result depends on their number. All members throw Cancelled once the observer says so, and what plugins throw.
///
/// Precondition of all questions: their points come from `select` of this session, or from the functions `select` and
/// `select_pairs` with its input and surface. Start distances of sources may be set afterwards. A session that was
/// moved from may only be assigned to or destroyed.
class Session {
 public:
  /// From a file. Mistakes are told before the surface is made: OptionError for plugins or options that do not exist,
  /// CapabilityError for a solver that lacks one of `demands`, InputError as `read_input`. Then SampleError for a
  /// sample that a stage refuses. `observer` must outlive the session, and must not ask it anything while it is told.
  explicit Session(const std::filesystem::path& file, RunSettings settings = {}, Observer& observer = silent_observer(),
                   Provides demands = Provides::nothing);

  /// From memory: see `make_input`. `settings.read` is not used. Throws as above.
  explicit Session(Input input, RunSettings settings = {}, Observer& observer = silent_observer(),
                   Provides demands = Provides::nothing);

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// They live as long as the session, also where it is moved to.
  const Input& input() const noexcept;
  const PlacedSurface& surface() const noexcept;
  /// The solver that was chosen, and its guarantee with the chosen options: distances are at most `factor` times the
  /// true ones; +inf for none.
  const PluginInfo& solver() const noexcept;
  double factor() const noexcept;

  /// O(F log F).
  SurfaceReport surface_report() const;
  /// Returns the report of `run_check` on the input, with this solver's part in the guarantee of a sample.
  CheckReport check() const;

  /// Points by the text that the function `select` reads: "all", "0,5,9", "0:100:10" or "@FILE". Throws as that. The
  /// observer is told of points that lie off the surface; each has its distance in `NamedPoint::off_surface`.
  std::vector<NamedPoint> select(const std::string& text) const;
  /// Rows of the input. Throws OptionError for one that is not there.
  std::vector<NamedPoint> select(std::span<const Index> rows) const;
  /// Points of the surface's mesh. Throws OptionError for a face that is not there and for barycentric coordinates that
  /// are negative or do not sum to 1.
  std::vector<NamedPoint> select(std::span<const SurfacePoint> points) const;
  /// Points in space: the closest surface points, as `x y z` in a list. The observer is told of those that lie off the
  /// surface, as above. Throws OptionError for one that is not finite, or beyond 1e100.
  /// O(log F) each, and once a call O(F log F) for a mesh, O(F) where distances are smooth.
  std::vector<NamedPoint> select(std::span<const Vec3> positions) const;

  /// Distances from all sources to all targets, a row per source, over threads: a search per source. Start distances of
  /// targets do not count. Throws OptionError for a start distance or a limit that is no number >= 0 and for a rule
  /// that input or sources do not allow, CapabilityError for what the solver or the reconstructor does not provide.
  /// Memory: a row and a search per thread, and what a solver that offers it (ManySearches) prepared for the rows of
  /// all `sources` together: it stays for the next call with the same sources and limit.
  std::vector<double> distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                const DistanceOptions& options = {}) const;
  /// Writes them into the caller's memory; throws OptionError unless it has sources.size() x targets.size() entries.
  void distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, std::span<double> out,
                 const DistanceOptions& options = {}) const;
  /// Hands them to a sink: the rows of `rows`, or all, that it does not have; without `rows` the sink is finished.
  /// Throws also OptionError for a row that no source has, and what the sink throws.
  void distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets, RowSink& sink,
                 const DistanceOptions& options = {}, std::optional<RowSet> rows = std::nullopt) const;

  /// Distances as above, with what the solver knows of the true ones from below: what it states by the extension
  /// LowerBounds, else D / factor. Throws also CapabilityError for a solver that has neither, OptionError for
  /// `printed`.
  BoundedDistances bounded_distances(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                     const DistanceOptions& options = {}) const;

  /// For every target the distance from the nearest source, and the place of that in `sources`: one search on one
  /// thread, and under the smooth metric one from each source that may be nearer than what that found. Throws
  /// OptionError for a start distance or a limit that is no number >= 0, CapabilityError for what the solver does not
  /// provide.
  std::vector<Distance> nearest(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                double max_distance = infinity) const;

  /// A shortest path; one search on one thread. Throws OptionError for `printed`, for a dropped end and for one with a
  /// start distance, InputError for one off the part, CapabilityError if the solver has no paths.
  PathResult path(const NamedPoint& from, const NamedPoint& to, ProjectionRule rule = ProjectionRule::project) const;

  /// Audits what the three members around here gave, by searches of other kinds, one line for each promise of the
  /// solver that is broken; none for one that holds or cannot be judged. A few searches on one thread. `nearest`: the
  /// search is repeated, around the sources with a map that is audited on a `share` of the faces, in (0, 1] (from a
  /// quarter on the map is of all faces), and held against searches from single sources and from targets. A path: it
  /// runs on the surface, is as long as its distance, and a search from its other end agrees. Pairs: searches for three
  /// of them, from both ends. Throw as those members.
  std::vector<std::string> audit_nearest(std::span<const NamedPoint> sources, std::span<const NamedPoint> targets,
                                         std::span<const Distance> nearest, double max_distance = infinity,
                                         double share = 0.01) const;
  std::vector<std::string> audit_path(const NamedPoint& from, const NamedPoint& to, const PathResult& path,
                                      ProjectionRule rule = ProjectionRule::project) const;
  std::vector<std::string> audit_pairs(std::span<const NamedPair> pairs, std::span<const double> distances) const;

  /// A distance for each pair, over threads, by the oracle of the solver, which is built with the first call and kept;
  /// under the smooth metric by a search from each place that pairs begin at. Throws OptionError for an end with a
  /// start distance, CapabilityError if the solver has no oracle, or, for a search, not what the ends take.
  std::vector<double> pairs(std::span<const NamedPair> pairs) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace geodrome
