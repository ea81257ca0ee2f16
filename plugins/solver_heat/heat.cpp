// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_heat/heat.hpp"

#include <array>
#include <cmath>
#include <mutex>
#include <utility>

#include "geodrome/solver_kit/vertex_map.hpp"
#include "plugins/solver_heat/heat_system.hpp"

namespace geodrome {
namespace {

using Systems = std::vector<std::unique_ptr<HeatSystem>>;  // one a component; null where it was not needed yet

/// The systems of searches that are not running.
class SystemPool {
 public:
  explicit SystemPool(std::size_t components) : components_(components) {}

  Systems take() {
    const std::scoped_lock lock(mutex_);
    if (idle_.empty()) return Systems(components_);
    Systems systems = std::move(idle_.back());
    idle_.pop_back();
    return systems;
  }
  void give_back(Systems systems) {
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(systems));
  }

 private:
  std::size_t components_;
  std::mutex mutex_;
  std::vector<Systems> idle_;
};

struct Prepared {
  MeshPtr mesh;
  SurfaceParts surface;
  mutable SystemPool pool;

  explicit Prepared(MeshPtr input) : mesh(std::move(input)), surface(*mesh), pool(surface.parts().size()) {}
};

/// Systems for as long as a run takes.
class Lease {
 public:
  explicit Lease(const Prepared& prepared) : prepared_(prepared), systems_(prepared.pool.take()) {}
  ~Lease() { prepared_.pool.give_back(std::move(systems_)); }
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;

  HeatSystem& of(Index part) {
    if (!systems_[part]) systems_[part] = std::make_unique<HeatSystem>(prepared_.surface.parts()[part]);
    return *systems_[part];
  }

 private:
  const Prepared& prepared_;
  Systems systems_;
};

class HeatSearch final : public Search {
 public:
  explicit HeatSearch(std::shared_ptr<const Prepared> prepared)
      : prepared_(std::move(prepared)), map_(*prepared_->mesh, prepared_->surface.components()) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    map_.begin(sources, request);
    require_provided(sources, request);
    Lease systems(*prepared_);
    for (Index i = 0; i < sources.size(); ++i) {
      context.throw_if_cancelled();
      spread(systems, prepared_->mesh->vertex_at(sources[i].at), i);
    }
    context.throw_if_cancelled();
    counters_[0].value = sources.size();
    map_.count(counters_);
    return map_;
  }

 private:
  void require_provided(std::span<const Source> sources, const Request& request) const {
    for (const Source& source : sources) {
      map_.vertex_of(source.at);
      if (source.start != 0) throw CapabilityError("sources with a start distance are not supported");
    }
    if (std::isfinite(request.radius)) throw CapabilityError("a radius is not supported");
    if (request.stop_at_targets) throw CapabilityError("stopping at targets is not supported");
  }

  /// One solve for each source: heat of several at once does not tell whose it is, nor are all of them then at one
  /// level.
  void spread(Lease& systems, Index vertex, Index source) {
    const PlaceInPart place = prepared_->surface.place(vertex);
    const std::vector<double>& distances = systems.of(place.part).from(place.vertex);
    const SurfacePart& part = prepared_->surface.parts()[place.part];
    for (std::size_t v = 0; v < distances.size(); ++v) map_.lower(part.vertex[v], distances[v], source);
  }

  std::shared_ptr<const Prepared> prepared_;
  VertexMap map_;
  std::array<Counter, 1> counters_{{{"solved_sources", 0}}};
};

class HeatPrepared final : public PreparedSurface {
 public:
  HeatPrepared(MeshPtr mesh, RunContext& context) : prepared_(std::make_shared<const Prepared>(std::move(mesh))) {
    Lease systems(*prepared_);
    for (Index part = 0; part < prepared_->surface.parts().size(); ++part) {
      context.throw_if_cancelled();
      systems.of(part);
    }
  }

  std::unique_ptr<Search> make_search() const override { return std::make_unique<HeatSearch>(prepared_); }

  /// Without the systems, whose size CGAL does not tell.
  std::size_t bytes() const override { return prepared_->surface.bytes(); }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace

std::unique_ptr<PreparedSurface> Heat::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  if (!mesh->manifold() || !mesh->oriented()) throw CapabilityError("the mesh must be manifold and oriented");
  return std::make_unique<HeatPrepared>(std::move(mesh), context);
}

}  // namespace geodrome
