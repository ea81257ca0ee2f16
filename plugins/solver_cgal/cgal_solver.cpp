// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_cgal/cgal_solver.hpp"

#include <CGAL/assertions_behaviour.h>

#include <memory>
#include <string>
#include <utility>

#include "geodrome/solver_kit/kept_search.hpp"
#include "plugins/common_gpl/guarded.hpp"
#include "plugins/solver_cgal/short_edges.hpp"
#include "plugins/solver_cgal/source_tree.hpp"

namespace geodrome {
namespace {

using cgal::Prepared;
using cgal::SourceTree;

/// A map of several sources holds a tree of each, about 4 kB a face: beyond 4 GB of them it is refused.
constexpr std::size_t most_faces_of_trees = std::size_t{1} << 20;

/// One tree of CGAL's for each source, and the least of their distances. Ties go to the lowest index.
class CgalSearch final : public KeptSearch {
 public:
  explicit CgalSearch(std::shared_ptr<const Prepared> prepared)
      : KeptSearch(*prepared->mesh, prepared->component),
        prepared_(std::move(prepared)),
        distances_(prepared_->mesh->vertex_count()),
        at_vertex_(distances_.size()) {}

 private:
  std::span<const double> vertices() const override { return distances_; }
  std::span<const Counter> counters() const override { return {}; }

  void refuse(std::span<const Source> sources, const Request& request) const override {
    if (request.stop_at_targets) throw CapabilityError("stopping at targets is not supported");
    const bool too_many = sources.size() > 1 && sources.size() * mesh().face_count() > most_faces_of_trees;
    if (request.keep == Keep::map && too_many)
      throw RefusedError("the map of " + std::to_string(sources.size()) + " sources would hold a search of " +
                             std::to_string(mesh().face_count()) + " faces for each",
                         "ask for fewer sources at once, or choose another solver");
  }

  void search(const Request& request, RunContext& context) override {
    trees_.clear();
    targets_.clear();
    at_vertex_.assign(at_vertex_.size(), {});
    for (Index i = 0; i < sources().size(); ++i) {
      auto tree = std::make_unique<const SourceTree>(prepared_, sources()[i].at, context);
      for (Index v = 0; v < at_vertex_.size(); ++v) take_nearer(at_vertex_[v], i, tree->at_vertex(v));
      targets_.assign(request.targets, [&](const SurfacePoint& target) {
        Distance best = i == 0 ? Distance() : targets_before_.at(target);
        take_nearer(best, i, tree->at(target));
        return best;
      });
      targets_before_ = targets_;
      if (keep() == Keep::map) trees_.push_back(std::move(tree));
      context.progress((i + 1.0) / static_cast<double>(sources().size()));
    }
    for (Index v = 0; v < at_vertex_.size(); ++v) {
      at_vertex_[v] = within_radius(at_vertex_[v]);
      distances_[v] = at_vertex_[v].value;
    }
  }

  Distance distance_at(const SurfacePoint& point) const override {
    if (const Index vertex = mesh().vertex_at(point); vertex != no_index) return at_vertex_[vertex];
    Distance best;
    for (Index i = 0; i < trees_.size(); ++i) take_nearer(best, i, trees_[i]->at(point));
    return within_radius(best);
  }
  Distance target_distance(const SurfacePoint& target) const override { return within_radius(targets_.at(target)); }

  void trace(const SurfacePoint& point, const Distance& distance, std::vector<SurfacePoint>& out) const override {
    trees_[distance.source]->trace(point, out);
    out.back() = sources()[distance.source].at;
  }

  void take_nearer(Distance& best, Index source, double distance) const {
    distance += sources()[source].start;
    if (distance < best.value) best = {distance, Reach::reached, source};
  }
  Distance within_radius(const Distance& distance) const {
    return distance.value > radius() && distance.reach == Reach::reached
               ? Distance{infinity, Reach::beyond_limit, no_index}
               : distance;
  }

  std::shared_ptr<const Prepared> prepared_;
  std::vector<std::unique_ptr<const SourceTree>> trees_;  // with Keep::map
  KeptTargets targets_, targets_before_;                  // before the radius
  std::vector<double> distances_;
  std::vector<Distance> at_vertex_;
};

class CgalPrepared final : public PreparedSurface {
 public:
  explicit CgalPrepared(MeshPtr mesh) : prepared_(std::make_shared<const Prepared>(std::move(mesh))) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<CgalSearch>(prepared_); }

  /// Per vertex a point, a half-edge, a removed flag and a component; per half-edge and face what CGAL's mesh links.
  std::size_t bytes() const override {
    const cgal::Mesh& copy = prepared_->copy;
    return copy.number_of_vertices() * (sizeof(cgal::Kernel::Point_3) + 3 * sizeof(Index)) +
           copy.number_of_halfedges() * 4 * sizeof(Index) + copy.number_of_faces() * 2 * sizeof(Index);
  }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace

std::unique_ptr<PreparedSurface> CgalSolver::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  if (!mesh->manifold() || !mesh->oriented()) throw CapabilityError("the mesh must be manifold and oriented");
  return cgal::with_lengths(*mesh, cgal::lost_share, [&] {
    return guarded([&] { return std::make_unique<CgalPrepared>(mesh); },
                   "check the mesh for needle faces and faces without area, or choose another solver");
  });
}

}  // namespace geodrome
