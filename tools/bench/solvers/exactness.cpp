// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/exactness.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/checks/seeded_subset.hpp"
#include "tools/bench/solvers/surface_points.hpp"
#include "tools/bench/solvers/witness.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::bench {
namespace {

/// |a - b|, 0 if both are the same infinity.
double apart(double a, double b) { return a == b ? 0 : std::abs(a - b); }

/// Where distances are compared: the same points, as the solver's mesh and as the peer's mesh name them.
struct Places {
  std::vector<SurfacePoint> ours, theirs;
  std::size_t vertices = 0;  ///< the first so many are vertices
};

/// Vertices on faces of both meshes; numbers above those of the peer's mesh are none of its vertices.
Places vertices_of(const SurfaceMesh& ours, const SurfaceMesh& theirs) {
  Places places;
  for (Index v = 0; v < theirs.vertex_count(); ++v) {
    if (theirs.first_half_edge(v) == no_index) continue;
    places.ours.push_back(ours.at_vertex(v));
    places.theirs.push_back(theirs.at_vertex(v));
  }
  places.vertices = places.ours.size();
  return places;
}

/// A source as the solver's mesh and as the peer's mesh name it.
struct SourcePair {
  Source ours, theirs;
};

/// The mesh times `factor`, moved to the origin before: far from it the product would move vertices by the rounding of
/// their coordinates, which is not small against the mesh, and distances would differ with no fault of the solver.
MeshPtr scaled_mesh(const SurfaceMesh& mesh, double factor) {
  std::vector<Vec3> positions;
  const Vec3 origin = mesh.positions().front();
  for (const Vec3& p : mesh.positions()) positions.push_back(factor * (p - origin));
  return std::make_shared<const SurfaceMesh>(std::move(positions),
                                             std::vector<Triangle>(mesh.triangles().begin(), mesh.triangles().end()));
}

/// All that is asked of the two solvers on one surface.
class Judge {
 public:
  Judge(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>* peer, MeshPtr mesh,
        MeshPtr peer_mesh, const ExactnessOptions& options)
      : plugin_(solver), mesh_(std::move(mesh)), options_(options) {
    try {
      if (peer)
        peer_.emplace(*peer, std::move(peer_mesh), options.seconds);
      else
        result_.peer_silent = "none was asked";
    } catch (const Error& error) {
      result_.peer_silent = error.what();
    }
  }

  Exactness run(std::span<const SourcePair> sources, const Places& places) {
    try {
      solver_.emplace(plugin_, mesh_, options_.seconds);
      for (const SourcePair& source : sources) judge_from(source, places);
      judge_together(sources, places);
      for (const double factor : {1.0, 1e-6, 1e6}) judge_scaled(factor, sources, places);
    } catch (const Error& error) {
      result_.failure = error.what();
    }
    return result_;
  }

 private:
  void judge_from(const SourcePair& source, const Places& places) {
    solver_->run({&source.ours, 1}, {.keep = Keep::map});
    const std::vector<double> ours = solver_->at(places.ours);
    const double scale = largest_finite(ours);
    check_unused_vertices();
    for (const std::size_t i : seeded_share(ours.size(), options_.share, options_.seed))
      if (std::isfinite(ours[i])) raise(result_.paths, apart(solver_->path_length(places.ours[i]), ours[i]) / scale);
    const AuditResult audit = solver_->audited(options_.share, options_.seed);
    if (std::max(audit.worst_lipschitz, audit.worst_path) > std::max(result_.lipschitz, result_.audit_paths))
      result_.where = audit.where;
    raise(result_.lipschitz, audit.worst_lipschitz);
    raise(result_.audit_paths, audit.worst_path);
    if (peer_) compare(source, places, ours, scale);
    single_runs_.push_back(ours);
  }

  void check_unused_vertices() {
    for (Index v = 0; v < mesh_->vertex_count(); ++v)
      if (mesh_->first_half_edge(v) == no_index && solver_->vertices()[v] != infinity)
        result_.failure = "a distance at vertex " + std::to_string(v) + ", which is on no face";
  }

  void compare(const SourcePair& source, const Places& places, const std::vector<double>& ours, double scale) {
    try {
      peer_->run({&source.theirs, 1}, {.keep = Keep::map});
      const std::vector<double> theirs = peer_->at(places.theirs);
      for (std::size_t i = 0; i < ours.size(); ++i) {
        if (apart(ours[i], theirs[i]) <= value_limit * scale)
          agree(i < places.vertices, ours[i], theirs[i], scale);
        else
          settle(places, i, ours[i], theirs[i], scale);
      }
    } catch (const Cancelled&) {
      result_.peer_silent = "given up after " + std::to_string(static_cast<long>(options_.seconds)) + " s";
      peer_.reset();
    } catch (const Error& error) {
      result_.peer_silent = error.what();
    }
  }

  void agree(bool at_vertex, double ours, double theirs, double scale) {
    const double difference = apart(ours, theirs);
    raise(at_vertex ? result_.at_vertices : result_.at_points, difference / scale);
    if (difference > 0 && theirs > 0) raise(result_.relative, difference / theirs);
  }

  /// The shorter value is right if it is the length of a path; the peer's may also be proven by any path of it that is
  /// shorter than the solver's value.
  void settle(const Places& places, std::size_t i, double ours, double theirs, double scale) {
    const double tolerance = value_limit * scale;
    const bool ours_is_shorter = ours < theirs;
    const bool solver_right = ours_is_shorter ? apart(solver_->path_length(places.ours[i]), ours) <= tolerance
                                              : !(peer_path_length(places.theirs[i], theirs) < ours - tolerance);
    if (!solver_right) {
      ++result_.solver_wrong;
      return agree(i < places.vertices, ours, theirs, scale);
    }
    ++result_.peer_wrong;
    raise(result_.peer_error, apart(ours, theirs) / scale);
  }

  /// A peer that traces no paths is believed.
  double peer_path_length(const SurfacePoint& from, double value) const {
    return peer_->provides(Provides::paths) ? peer_->path_length(from) : value;
  }

  /// From all sources, with start distances: the least of what each gave alone.
  void judge_together(std::span<const SourcePair> sources, const Places& places) {
    if (sources.size() < 2 || !solver_->provides(Provides::start_distances)) return;
    std::vector<Source> all;
    shapes::Random random(options_.seed);
    const double latest = 0.3 * largest_finite(single_runs_.front());
    for (const SourcePair& source : sources) all.push_back({source.ours.at, latest * random.uniform()});
    solver_->run(all, {.keep = Keep::map});
    const std::vector<double> together = solver_->at(places.ours);
    const double scale = largest_finite(together);
    for (std::size_t i = 0; i < together.size(); ++i) {
      double least = infinity;
      for (std::size_t s = 0; s < all.size(); ++s) least = std::min(least, all[s].start + single_runs_[s][i]);
      raise(result_.together, apart(together[i], least) / scale);
    }
  }

  void judge_scaled(double factor, std::span<const SourcePair> sources, const Places& places) {
    Witness scaled(plugin_, scaled_mesh(*mesh_, factor), options_.seconds);
    for (std::size_t s = 0; s < sources.size(); ++s) {
      scaled.run({&sources[s].ours, 1}, {.targets = places.ours, .keep = Keep::targets});
      const std::vector<double> values = scaled.at(places.ours);
      const double scale = largest_finite(single_runs_[s]);
      for (std::size_t i = 0; i < values.size(); ++i)
        raise(result_.scaled, apart(values[i] / factor, single_runs_[s][i]) / scale);
    }
  }

  const Plugin<ShortestPathSolver>& plugin_;
  MeshPtr mesh_;
  ExactnessOptions options_;
  std::optional<Witness> solver_, peer_;
  std::vector<std::vector<double>> single_runs_;  ///< of the solver, per source
  Exactness result_;
};

}  // namespace

double largest_finite(std::span<const double> values) {
  double largest = 0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest > 0 ? largest : 1;
}

void raise(double& worst, double figure) { worst = std::max(worst, std::isnan(figure) ? infinity : figure); }

bool Exactness::exact() const {
  const auto within = [](double figure, double limit) { return figure <= limit; };
  return failure.empty() && solver_wrong == 0 && within(at_vertices, value_limit) && within(at_points, value_limit) &&
         within(paths, value_limit) && within(together, value_limit) && within(scaled, value_limit) &&
         within(lipschitz, audit_limit) && within(audit_paths, audit_limit);
}

Exactness judge(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>* peer, const MeshPtr& mesh,
                const ExactnessOptions& options) {
  if (mesh->face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  shapes::Random random(options.seed);
  constexpr SurfacePoint (*kinds[])(const SurfaceMesh&, shapes::Random&) = {random_vertex, random_inner_point,
                                                                            random_edge_point};
  std::vector<SourcePair> sources;
  for (std::size_t i = 0; i < options.sources; ++i) {
    const Source source{kinds[i % std::size(kinds)](*mesh, random)};
    sources.push_back({source, source});
  }
  Places places = vertices_of(*mesh, *mesh);
  for (std::size_t i = 0; i < options.points; ++i) {
    places.ours.push_back(random_inner_point(*mesh, random));
    places.theirs.push_back(places.ours.back());
  }
  return Judge(solver, peer, mesh, mesh, options).run(sources, places);
}

Exactness judge_refined(const Plugin<ShortestPathSolver>& solver, const Plugin<ShortestPathSolver>* peer,
                        const MeshPtr& coarse, const MeshPtr& refined, const ExactnessOptions& options) {
  if (coarse->face_count() == 0) throw InputError(InputFault::empty, "the mesh has no face");
  shapes::Random random(options.seed);
  std::vector<SourcePair> sources;
  for (std::size_t i = 0; i < options.sources; ++i) {
    const SurfacePoint theirs = random_vertex(*coarse, random);
    sources.push_back({{refined->at_vertex(coarse->vertex_at(theirs))}, {theirs}});
  }
  return Judge(solver, peer, refined, coarse, options).run(sources, vertices_of(*refined, *coarse));
}

}  // namespace geodrome::bench
