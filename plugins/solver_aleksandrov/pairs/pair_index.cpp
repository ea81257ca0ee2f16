// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/pairs/pair_index.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <memory>
#include <ostream>

#include "plugins/common/parallel_for.hpp"
#include "plugins/solver_aleksandrov/pairs/least_sum.hpp"
#include "plugins/solver_aleksandrov/pairs/region_tree.hpp"

namespace geodrome::aleksandrov {
namespace {

/// A sum of two floats that were rounded up is below the true one by less than this share, and above by less than
/// twice as much more; where they are next to 0, by less than this length.
constexpr double float_share = 1.2e-7, float_least = 4 * std::numeric_limits<float>::denorm_min();
constexpr std::size_t leaf_faces = 128;

/// A region as a mesh of its own.
struct Part {
  MeshPtr mesh;
  std::vector<Index> vertex;  ///< its vertices in the whole mesh
  std::vector<Index> face;    ///< of the whole mesh -> here; only for faces of the region

  Part(const SurfaceMesh& whole, const std::vector<Index>& faces, std::vector<Index>& scratch)
      : face(whole.face_count(), no_index) {
    std::vector<Triangle> triangles;
    std::vector<Vec3> positions;
    for (const Index f : faces) {
      face[f] = static_cast<Index>(triangles.size());
      Triangle& t = triangles.emplace_back(whole.triangles()[f]);
      for (Index& v : t) {
        if (scratch[v] == no_index) {
          scratch[v] = static_cast<Index>(vertex.size());
          vertex.push_back(v);
          positions.push_back(whole.positions()[v]);
        }
        v = scratch[v];
      }
    }
    for (const Index v : vertex) scratch[v] = no_index;
    mesh = std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles));
  }
};

float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

template <class T>
void write(std::ostream& out, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  out.write(reinterpret_cast<const char*>(&count), sizeof count);
  out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

[[noreturn]] void damaged() {
  throw InputError(InputFault::syntax, "the saved pair index is cut off, damaged or of another mesh", "make it anew");
}

/// In pieces, none larger than what was there before it, so that a wrong count fails at the end of the file and not for
/// lack of memory.
template <class T>
void read(std::istream& in, std::vector<T>& values) {
  std::uint64_t count = 0;
  if (!in.read(reinterpret_cast<char*>(&count), sizeof count)) damaged();
  constexpr std::uint64_t first_piece = 1 << 10;
  for (std::uint64_t got = 0; got < count; got = values.size()) {
    const std::uint64_t more = std::min(std::max(first_piece, got), count - got);
    values.resize(got + more);
    if (!in.read(reinterpret_cast<char*>(values.data() + got), static_cast<std::streamsize>(more * sizeof(T))))
      damaged();
  }
}

constexpr std::uint64_t magic = 0x3230524941504447;  // "GDPAIR02", little-endian

}  // namespace

PairIndex::PairIndex(MeshPtr mesh, double spacing, const ShortestPathSolver& exact, RunContext& context) {
  const RegionTree tree(*mesh, spacing, leaf_faces, context);
  leaf_ = tree.leaf_of_vertex();
  double work = 0, done = 0;
  for (const Region& region : tree.regions()) {
    const bool top = region.parent == no_index;
    const Columns parent = top ? Columns{} : regions_[region.parent];
    const auto first = top ? 0 : parent.last;
    regions_.push_back({region.parent, top ? 0 : parent.depth + 1, first,
                        first + static_cast<std::uint32_t>(region.portals.size()), region.detour});
    work += static_cast<double>(region.portals.size() * region.faces.size());
  }
  first_.assign(1, 0);
  for (const Index leaf : leaf_) first_.push_back(first_.back() + (leaf == no_index ? 0 : regions_[leaf].last));
  distance_.assign(first_.back(), std::numeric_limits<float>::infinity());

  std::vector<Index> scratch(mesh->vertex_count(), no_index);
  for (Index r = 0; r < regions_.size(); ++r) {
    const Region& region = tree.regions()[r];
    if (region.portals.empty()) continue;
    const Part part(*mesh, region.faces, scratch);
    const auto prepared = exact.prepare(part.mesh, context);
    std::vector<Index> rows;  // of the region's own vertices
    for (Index i = 0; i < part.vertex.size(); ++i) {
      Index leaf = leaf_[part.vertex[i]];
      while (leaf != no_index && leaf > r) leaf = regions_[leaf].parent;
      if (leaf == r) rows.push_back(i);
    }
    const double share = static_cast<double>(region.portals.size() * region.faces.size());
    parallel_for(region.portals.size(), context, {done / work, (done + share) / work},
                 [&](std::size_t begin, std::size_t end) {
                   const auto search = prepared->make_search();
                   QuietContext quiet;
                   for (std::size_t p = begin; p < end; ++p) {
                     const Source source{{part.face[region.portals[p].face], region.portals[p].b}};
                     const auto values = search->run({&source, 1}, {}, quiet).vertices();
                     for (const Index i : rows)
                       distance_[first_[part.vertex[i]] + regions_[r].first + p] = rounded_up(values[i]);
                   }
                 });
    done += share;
  }
}

Bounds PairIndex::between(Index from, Index to) const {
  if (from == to) return {0, 0};
  Index a = leaf_[from], b = leaf_[to];
  if (a == no_index || b == no_index) return {infinity, infinity};
  double least = infinity, most = infinity;
  if (a == b && regions_[a].first == regions_[a].last) least = 0;
  while (regions_[a].depth > regions_[b].depth) a = regions_[a].parent;
  while (regions_[b].depth > regions_[a].depth) b = regions_[b].parent;
  while (a != b) a = regions_[a].parent, b = regions_[b].parent;
  const float *here = distance_.data() + first_[from], *there = distance_.data() + first_[to];
  for (; a != no_index; a = regions_[a].parent) {
    const Columns& region = regions_[a];
    const double sum = least_sum(here + region.first, there + region.first, region.last - region.first);
    most = std::min(most, sum * (1 + float_share));
    least = std::min(least, sum * (1 - 2 * float_share) - float_least - region.detour);
  }
  return {std::max(0.0, least), most};
}

std::size_t PairIndex::bytes() const {
  return regions_.size() * sizeof(Columns) + leaf_.size() * sizeof(Index) + first_.size() * sizeof(first_[0]) +
         distance_.size() * sizeof(float);
}

void PairIndex::save(std::ostream& out) const {
  out.write(reinterpret_cast<const char*>(&magic), sizeof magic);
  write(out, regions_), write(out, leaf_), write(out, first_), write(out, distance_);
}

PairIndex::PairIndex(const SurfaceMesh& mesh, std::istream& in) {
  std::uint64_t found = 0;
  if (!in.read(reinterpret_cast<char*>(&found), sizeof found) || found != magic) damaged();
  read(in, regions_), read(in, leaf_), read(in, first_), read(in, distance_);
  check(mesh);
}

/// Whatever stands in the file, no query may reach beyond the tables or take what is no distance for one.
void PairIndex::check(const SurfaceMesh& mesh) const {
  if (leaf_.size() != mesh.vertex_count() || first_.size() != leaf_.size() + 1 || first_[0] != 0) damaged();
  for (Index r = 0; r < regions_.size(); ++r) {
    const Columns& c = regions_[r];
    const bool top = c.parent == no_index;
    if (!(c.detour >= 0 && std::isfinite(c.detour))) damaged();
    if (c.first > c.last || (!top && c.parent >= r) || (r == 0) != top) damaged();
    if (c.depth != (top ? 0 : regions_[c.parent].depth + 1) || c.first != (top ? 0 : regions_[c.parent].last))
      damaged();
  }
  for (Index v = 0; v < leaf_.size(); ++v) {
    if (leaf_[v] != no_index && leaf_[v] >= regions_.size()) damaged();
    if (first_[v + 1] - first_[v] != (leaf_[v] == no_index ? 0 : regions_[leaf_[v]].last)) damaged();
  }
  if (first_.back() != distance_.size()) damaged();
  for (const float distance : distance_)
    if (!(distance >= 0)) damaged();
}

}  // namespace geodrome::aleksandrov
