// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/pairs/region_tree.hpp"

#include <metis.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <mutex>
#include <new>
#include <string>
#include <unordered_map>

namespace geodrome::aleksandrov {
namespace {

using Uses = std::vector<detail::EdgeUse>;

/// All faces of a region with a common edge, as a graph in compressed rows.
struct DualGraph {
  std::vector<idx_t> first, neighbour;
};

std::vector<Triangle> triangles_of(const SurfaceMesh& mesh, const std::vector<Index>& faces) {
  std::vector<Triangle> triangles;
  triangles.reserve(faces.size());
  for (const Index f : faces) triangles.push_back(mesh.triangles()[f]);
  return triangles;
}

/// Calls `visit(begin, end)` for the uses of each edge.
template <class Visit>
void for_each_edge(const Uses& uses, Visit&& visit) {
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    visit(i, end);
  }
}

DualGraph dual_graph(const Uses& uses, std::size_t faces) {
  std::vector<std::pair<idx_t, idx_t>> pairs;
  for_each_edge(uses, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = begin; j < end; ++j) {
        const auto f = static_cast<idx_t>(uses[i].half_edge / 3), g = static_cast<idx_t>(uses[j].half_edge / 3);
        if (f != g) pairs.emplace_back(f, g);
      }
  });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  DualGraph graph;
  graph.first.assign(faces + 1, 0);
  for (const auto& [f, g] : pairs) ++graph.first[f + 1], graph.neighbour.push_back(g);
  for (std::size_t f = 0; f < faces; ++f) graph.first[f + 1] += graph.first[f];
  return graph;
}

/// While METIS runs it takes SIGTERM and SIGABRT of the whole process for its own errors, and at its end it gives back
/// the handlers that it found. So it runs once at a time, and a SIGTERM from outside waits till the program's own
/// handler is back.
class SignalsOfMetis {
 public:
  SignalsOfMetis() : one_at_a_time_(mutex_) {
    sigset_t from_outside;
    sigemptyset(&from_outside);
    sigaddset(&from_outside, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &from_outside, &before_);
  }
  ~SignalsOfMetis() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsOfMetis(const SignalsOfMetis&) = delete;
  SignalsOfMetis& operator=(const SignalsOfMetis&) = delete;

 private:
  static inline std::mutex mutex_;
  const std::lock_guard<std::mutex> one_at_a_time_;
  sigset_t before_;
};

/// Which half each face belongs to. The same on every run.
std::vector<idx_t> halves(DualGraph graph) {
  idx_t count = static_cast<idx_t>(graph.first.size()) - 1, constraints = 1, parts = 2, cut = 0;
  std::vector<idx_t> part(count);
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NCUTS] = 4;
  graph.neighbour.push_back(0);  // never read; METIS wants an array, even where there are no edges
  const SignalsOfMetis signals;
  const int status = METIS_PartGraphRecursive(&count, &constraints, graph.first.data(), graph.neighbour.data(), nullptr,
                                              nullptr, nullptr, &parts, nullptr, nullptr, options, &cut, part.data());
  if (status == METIS_ERROR_MEMORY) throw std::bad_alloc();
  if (status != METIS_OK)
    throw NumericalError("METIS could not cut the surface (status " + std::to_string(status) + ")");
  return part;
}

}  // namespace

RegionTree::RegionTree(const SurfaceMesh& mesh, double spacing, std::size_t leaf_faces, const RunContext& context)
    : leaf_of_vertex_(mesh.vertex_count(), no_index) {
  Region& all = regions_.emplace_back();
  for (Index f = 0; f < mesh.face_count(); ++f) all.faces.push_back(f);
  for (Index r = 0; r < regions_.size(); ++r) {
    context.throw_if_cancelled();
    if (regions_[r].faces.size() > leaf_faces && split(mesh, r, spacing)) continue;
    for (const Index f : regions_[r].faces)
      for (const Index v : mesh.triangles()[f])
        if (SurfaceMesh::face(mesh.first_half_edge(v)) == f) leaf_of_vertex_[v] = r;
  }
}

bool RegionTree::split(const SurfaceMesh& mesh, Index region, double spacing) {
  const std::vector<Index>& faces = regions_[region].faces;
  const Uses uses = detail::sorted_edge_uses(triangles_of(mesh, faces));
  const std::vector<idx_t> part = halves(dual_graph(uses, faces.size()));

  Region half[2];
  std::unordered_map<Index, int> seen_by;  // vertex -> bits of the halves
  for (std::size_t i = 0; i < faces.size(); ++i) {
    half[part[i]].parent = region;
    half[part[i]].faces.push_back(faces[i]);
    for (const Index v : mesh.triangles()[faces[i]]) seen_by[v] |= 1 << part[i];
  }
  if (half[0].faces.empty() || half[1].faces.empty()) return false;

  Region& cut = regions_[region];
  for (const Index f : faces)
    for (Index i = 0; i < 3; ++i) {
      int& bits = seen_by[mesh.triangles()[f][i]];
      if (bits != 3) continue;
      SurfacePoint at{f, {}};
      at.b[i] = 1;
      cut.portals.push_back(at);
      bits = 0;  // once
    }
  for_each_edge(uses, [&](std::size_t begin, std::size_t end) {
    bool both[2] = {false, false};
    for (std::size_t i = begin; i < end; ++i) both[part[uses[i].half_edge / 3]] = true;
    if (!both[0] || !both[1]) return;
    const Index h = uses[begin].half_edge, f = faces[h / 3];
    const double length = distance(mesh.positions()[uses[begin].low], mesh.positions()[uses[begin].high]);
    const double pieces = std::max(1.0, std::ceil(length / spacing));
    cut.detour = std::max(cut.detour, length / pieces);
    for (double k = 1; k < pieces; ++k) {
      SurfacePoint at{f, {}};
      at.b[h % 3] = 1 - k / pieces, at.b[(h + 1) % 3] = k / pieces;
      cut.portals.push_back(at);
    }
  });
  regions_.push_back(std::move(half[0]));
  regions_.push_back(std::move(half[1]));
  return true;
}

}  // namespace geodrome::aleksandrov
