// SPDX-License-Identifier: MIT
#include "plugins/common/surfaces/finished_surface.hpp"

#include <algorithm>
#include <utility>

#include "plugins/common/surfaces/manifold_faces.hpp"
#include "plugins/common/surfaces/surface_inserter.hpp"

namespace geodrome {
namespace {

constexpr double most_unused = 0.05;  ///< share of the kept points that the surface may leave out
constexpr std::size_t shown = 10;     ///< elements a finding lists

/// Sorts faces: lowest corner first, faces ascending.
void put_in_order(std::vector<Triangle>& faces) {
  for (Triangle& t : faces) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(faces.begin(), faces.end());
}

[[noreturn]] void refuse(const Reconstruction& result, std::string message, Remedy remedy) {
  throw SampleError(std::move(message), std::move(remedy), result.findings);
}

void require_surface(const Reconstruction& result, const std::vector<Triangle>& faces, std::size_t point_count) {
  if (faces.empty())
    refuse(result, "the kept points give no faces", "sample more densely, or choose another control function");
  const detail::Connectivity connectivity = detail::connect(faces, point_count);
  if (!connectivity.manifold) refuse(result, "the surface is no 2-manifold", "choose another reconstructor");
  if (!connectivity.oriented) refuse(result, "the surface cannot be oriented", "choose another reconstructor");
}

/// Keeps the points that faces use, in their order, and says which were left out.
void build_mesh(Reconstruction& result, std::vector<Triangle> faces, const KeptPoints& kept) {
  std::vector<Index> vertex_of(kept.points.size(), no_index), unused;
  for (const Triangle& t : faces)
    for (const Index p : t) vertex_of[p] = 0;
  std::vector<Vec3> positions;
  for (Index p = 0; p < kept.points.size(); ++p) {
    if (vertex_of[p] == no_index) {
      unused.push_back(kept.sample[p]);
      continue;
    }
    vertex_of[p] = static_cast<Index>(positions.size());
    positions.push_back(kept.points[p]);
    result.sample_of_vertex.push_back(kept.sample[p]);
  }
  for (Triangle& t : faces)
    for (Index& p : t) p = vertex_of[p];
  const std::size_t count = unused.size();
  if (count > 0)
    result.findings.push_back(finding(Finding::Severity::warning, "unused_points",
                                      counted(count, "kept point is", "kept points are") +
                                          " on no face of the surface and left out: the sample may be too sparse or "
                                          "too noisy there.",
                                      count, unused));
  if (static_cast<double>(count) > most_unused * static_cast<double>(kept.points.size()))
    refuse(result,
           std::to_string(count) + " of " + std::to_string(kept.points.size()) +
               " kept points are on no face of the surface, the first is point " + std::to_string(unused[0]),
           "the sample is too sparse or too noisy: sample more densely, or choose another reconstructor");
  result.mesh = std::make_shared<const SurfaceMesh>(std::move(positions), std::move(faces));
}

void judge(Reconstruction& result, BoundaryRule rule) {
  const BoundaryFacts facts = boundary_facts(*result.mesh);
  std::vector<Index> points;
  for (const Index v : facts.some_vertices) points.push_back(result.sample_of_vertex[v]);
  if (facts.loops > 0 && rule == BoundaryRule::closed)
    refuse(result,
           "the surface has " + counted(facts.loops, "boundary loop", "boundary loops") + ", one at point " +
               std::to_string(points[0]),
           "sample more densely there, or allow a boundary with boundary=auto");
  if (facts.loops > 0)
    result.findings.push_back(finding(
        rule == BoundaryRule::open ? Finding::Severity::note : Finding::Severity::warning, "boundary",
        "the surface has " + counted(facts.loops, "boundary loop", "boundary loops") +
            " (the points named are on them): sample more densely there if it should be closed, say boundary=open if "
            "not.",
        facts.loops, points));
  if (facts.components > 1)
    result.findings.push_back(finding(Finding::Severity::note, "components",
                                      "the surface has " + std::to_string(facts.components) +
                                          " components: no edge is longer than 4.96 psi, so what lies farther apart is "
                                          "not connected.",
                                      facts.components));
}

}  // namespace

Finding finding(Finding::Severity severity, const char* code, std::string message, std::size_t count,
                std::vector<Index> places) {
  places.resize(std::min(places.size(), shown));
  return {severity, code, std::move(message), count, std::move(places)};
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

KeptPoints kept_points(const PointSample& sample, const Tangents& tangents, const Control& control,
                       std::span<const Index> kept) {
  if (kept.size() < 3)
    throw SampleError("a surface needs at least three points, there are " + std::to_string(kept.size()),
                      "give more points");
  KeptPoints result;
  result.sample.assign(kept.begin(), kept.end());
  for (const Index i : kept) {
    result.points.push_back(sample.points[i]);
    result.normals.push_back(tangents.plane[i].normal);
    result.psi.push_back(control.psi[i]);
  }
  return result;
}

void finish(Reconstruction& result, std::vector<Triangle> faces, const KeptPoints& kept, const PointSample& sample,
            BoundaryRule rule) {
  require_surface(result, faces, kept.points.size());
  put_in_order(faces);
  build_mesh(result, std::move(faces), kept);
  judge(result, rule);
  result.inserter = make_inserter(result.mesh, result.sample_of_vertex, sample);
}

}  // namespace geodrome
