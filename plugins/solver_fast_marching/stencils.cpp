// SPDX-License-Identifier: MIT
#include "plugins/solver_fast_marching/stencils.hpp"

#include <algorithm>

#include "plugins/solver_fast_marching/splitting.hpp"

namespace geodrome {
namespace {

/// Cosines down to this count as those of right angles: rounding must not decide whether a square's corner is split.
constexpr double right_angle = -1e-9;

Stencil stencil(Index target, const PlacedVertex& a, const PlacedVertex& b) {
  const Place side = b.at - a.at, way = Place{0, 0} - a.at;
  const double square = dot(side, side);
  const bool flat = !(square > 0);
  return {target,
          b.vertex,
          length(a.at),
          std::sqrt(square),
          flat ? 0 : dot(way, side) / square,
          flat ? 0 : std::abs(cross(way, side)) / square};
}

/// Calls `visit(from, stencil)` for all stencils that come from corner `i` of a face.
template <class Visit>
void for_each_stencil(const PackedMesh& surface, Index f, int i, Visit&& visit) {
  const PackedMesh::Face& face = surface.face(f);
  const SeenFace seen(face, i);
  const auto triangle = [&](const PlacedVertex& a, const PlacedVertex& b) {
    visit(a.vertex, stencil(face.vertex[i], a, b));
    visit(b.vertex, stencil(face.vertex[i], b, a));
  };
  const auto between = face.cosine[i] < right_angle ? ObtuseSplit::find(surface, f, i) : std::nullopt;
  if (!between || between->vertex == face.vertex[i]) return triangle(seen.right, seen.left);
  triangle(seen.right, *between);
  triangle(*between, seen.left);
}

}  // namespace

Stencils::Stencils(const PackedMesh& surface) : first_(surface.vertex_count() + 1, 0) {
  std::vector<std::pair<Index, Stencil>> all;
  all.reserve(6 * surface.face_count());
  for (Index f = 0; f < surface.face_count(); ++f)
    for (int i = 0; i < 3; ++i)
      for_each_stencil(surface, f, i, [&](Index from, const Stencil& s) {
        all.emplace_back(from, s);
        ++first_[from + 1];
      });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  stencils_.resize(all.size());
  std::vector<std::size_t> end(first_.begin(), first_.end() - 1);
  for (const auto& [from, s] : all) stencils_[end[from]++] = s;
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::stable_sort(stencils_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
                     stencils_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]),
                     [](const Stencil& a, const Stencil& b) { return a.target < b.target; });
}

}  // namespace geodrome
