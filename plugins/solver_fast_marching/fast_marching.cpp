// SPDX-License-Identifier: MIT
#include "plugins/solver_fast_marching/fast_marching.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "geodrome/solver_kit/vertex_map.hpp"
#include "plugins/solver_fast_marching/front.hpp"

namespace geodrome {
namespace {

struct Prepared {
  PackedMesh surface;
  Stencils stencils;

  explicit Prepared(MeshPtr mesh) : surface(std::move(mesh)), stencils(surface) {}
};

class FastMarchingSearch final : public Search {
 public:
  explicit FastMarchingSearch(std::shared_ptr<const Prepared> prepared)
      : prepared_(std::move(prepared)),
        front_(prepared_->stencils, surface().vertex_count()),
        map_(surface().mesh(), surface().components()) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    context.throw_if_cancelled();
    map_.begin(sources, request);
    front_.clear();
    for (Index i = 0; i < sources.size(); ++i) seed(sources[i], i);
    if (request.stop_at_targets)
      for (const SurfacePoint& target : request.targets)
        front_.want(surface().vertex_of_original(map_.vertex_of(target)));
    front_.march(std::ldexp(request.radius, surface().exponent()), request.stop_at_targets, context);
    for (const Index v : front_.settled()) {
      const double distance = std::ldexp(front_.distance(v), -surface().exponent());
      if (distance <= request.radius) map_.lower(surface().original_vertex(v), distance, front_.source(v));
    }
    counters_[0].value = front_.settled().size();
    counters_[1].value = front_.bytes() + map_.bytes();
    map_.count(counters_);
    return map_;
  }

 private:
  const PackedMesh& surface() const { return prepared_->surface; }

  /// Straight lines from the source to the corners of every face that holds it.
  void seed(const Source& source, Index number) {
    const double start = std::ldexp(source.start, surface().exponent());
    const Index vertex = surface().mesh().vertex_at(source.at);
    if (vertex == no_index)
      return surface().for_each_name(surface().inner(source.at), [&](const SurfacePoint& name) {
        for (Index h = 3 * name.face; h < 3 * name.face + 3; ++h) {
          const auto [x, y] = surface().in_frame(h, name.b);
          front_.seed(surface().from(h), start + std::hypot(x, y), number);
        }
      });
    const Index v = surface().vertex_of_original(vertex);
    front_.seed(v, start, number);
    for (const Index h : surface().corners(v))
      for (const Index side : {h, SurfaceMesh::previous(h)})
        front_.seed(surface().from(side == h ? SurfaceMesh::next(h) : side), start + surface().length(side), number);
  }

  std::shared_ptr<const Prepared> prepared_;
  Front front_;
  VertexMap map_;
  std::array<Counter, 2> counters_{{{"settled_vertices", 0}, {"largest_search_bytes", 0}}};
};

class FastMarchingPrepared final : public PreparedSurface {
 public:
  explicit FastMarchingPrepared(MeshPtr mesh) : prepared_(std::make_shared<const Prepared>(std::move(mesh))) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<FastMarchingSearch>(prepared_); }
  std::size_t bytes() const override { return prepared_->surface.bytes() + prepared_->stencils.bytes(); }

 private:
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace

std::unique_ptr<PreparedSurface> FastMarching::prepare(MeshPtr mesh, RunContext& context) const {
  context.throw_if_cancelled();
  require_unweighted(*mesh);
  return std::make_unique<FastMarchingPrepared>(std::move(mesh));
}

}  // namespace geodrome
