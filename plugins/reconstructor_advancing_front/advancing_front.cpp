// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_advancing_front/advancing_front.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "plugins/common/manifold_faces.hpp"
#include "plugins/common/surface_inserter.hpp"
#include "plugins/reconstructor_advancing_front/front_triangles.hpp"

namespace geodrome {
namespace {

constexpr double most_unused = 0.05;  ///< share of the kept points that the surface may leave out
constexpr std::size_t shown = 10;     ///< elements a finding lists

Finding found(Finding::Severity severity, const char* code, std::string message, std::size_t count,
              std::vector<Index> elements = {}) {
  return {severity, code, std::move(message), count, std::move(elements)};
}

/// "1 face", "2 faces".
std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// Keeps the points that faces use, in their order, and says which were left out.
void build_mesh(Reconstruction& result, std::vector<Triangle> faces, std::span<const Vec3> points,
                std::span<const Index> kept) {
  std::vector<Index> vertex_of(points.size(), no_index);
  for (const Triangle& t : faces)
    for (const Index p : t) vertex_of[p] = 0;
  std::vector<Vec3> positions;
  std::vector<Index> unused;
  for (Index p = 0; p < points.size(); ++p) {
    if (vertex_of[p] == no_index) {
      unused.push_back(kept[p]);
      continue;
    }
    vertex_of[p] = static_cast<Index>(positions.size());
    positions.push_back(points[p]);
    result.sample_of_vertex.push_back(kept[p]);
  }
  for (Triangle& t : faces)
    for (Index& p : t) p = vertex_of[p];
  const std::size_t count = unused.size();
  if (static_cast<double>(count) > most_unused * static_cast<double>(points.size()))
    throw SampleError(std::to_string(count) + " of " + std::to_string(points.size()) +
                          " kept points are on no face of the surface, the first is point " + std::to_string(unused[0]),
                      "the sample is too sparse or too noisy: sample more densely, or choose another reconstructor");
  unused.resize(std::min(count, shown));
  if (count > 0)
    result.findings.push_back(found(Finding::Severity::warning, "unused_points",
                                    counted(count, "kept point is", "kept points are") +
                                        " on no face of the surface and left out: the sample may be too sparse or "
                                        "too noisy there.",
                                    count, unused));
  result.mesh = std::make_shared<const SurfaceMesh>(std::move(positions), std::move(faces));
}

void judge(Reconstruction& result, const std::string& boundary) {
  const BoundaryFacts facts = boundary_facts(*result.mesh);
  std::vector<Index> points;
  for (const Index v : facts.some_vertices) points.push_back(result.sample_of_vertex[v]);
  if (facts.loops > 0 && boundary == "closed")
    throw SampleError("the surface has " + counted(facts.loops, "boundary loop", "boundary loops") + ", one at point " +
                          std::to_string(points[0]),
                      "sample more densely there, or allow a boundary with boundary=auto");
  if (facts.loops > 0)
    result.findings.push_back(found(boundary == "open" ? Finding::Severity::note : Finding::Severity::warning,
                                    "boundary",
                                    "the surface has " + counted(facts.loops, "boundary loop", "boundary loops") +
                                        " (the points named are on them): sample more densely there if it should "
                                        "be closed, say boundary=open if not.",
                                    facts.loops, points));
  if (facts.components > 1)
    result.findings.push_back(found(Finding::Severity::note, "components",
                                    "the surface has " + std::to_string(facts.components) +
                                        " components: no edge is longer than 4.96 psi, so what lies farther apart is "
                                        "not connected.",
                                    facts.components));
}

/// The order in which CGAL lists faces and their corners follows addresses in memory: lowest corner first, faces
/// ascending.
void put_in_order(std::vector<Triangle>& faces) {
  for (Triangle& t : faces) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(faces.begin(), faces.end());
}

void require_surface(const std::vector<Triangle>& faces, std::size_t point_count) {
  if (faces.empty())
    throw SampleError("the kept points give no faces", "sample more densely, or choose another control function");
  const detail::Connectivity connectivity = detail::connect(faces, point_count);
  if (!connectivity.manifold) throw SampleError("the surface is no 2-manifold", "choose another reconstructor");
  if (!connectivity.oriented) throw SampleError("the surface cannot be oriented", "choose another reconstructor");
}

}  // namespace

Reconstruction AdvancingFront::reconstruct(const PointSample& sample, const Tangents&, const Control& control,
                                           std::span<const Index> kept, RunContext& context) const {
  context.throw_if_cancelled();
  if (kept.size() < 3)
    throw SampleError("a surface needs at least three points, there are " + std::to_string(kept.size()),
                      "give more points");
  std::vector<Vec3> points;
  std::vector<double> psi;
  for (const Index i : kept) points.push_back(sample.points[i]), psi.push_back(control.psi[i]);

  Reconstruction result;
  const auto plane = common_plane(points);
  const FaceRule rule{points, psi, plane || boundary_ != "closed"};
  std::size_t cut = 0;
  std::vector<Triangle> faces = plane ? planar_triangles(*plane, rule, cut) : front_triangles(rule);
  context.throw_if_cancelled();
  if (plane)
    result.findings.push_back(found(Finding::Severity::note, "planar",
                                    "the sample is planar and was triangulated in its plane; " +
                                        counted(cut, "triangle", "triangles") + " too large for psi left out.",
                                    cut));
  const std::size_t dropped = drop_minor_fans(faces, points.size());
  if (dropped > 0)
    result.findings.push_back(found(Finding::Severity::warning, "dropped_faces",
                                    counted(dropped, "face", "faces") + " met the rest in a single point and left out.",
                                    dropped));
  require_surface(faces, points.size());
  orient_outwards(faces, points);
  put_in_order(faces);
  build_mesh(result, std::move(faces), points, kept);
  judge(result, boundary_);
  result.inserter = make_inserter(result.mesh, result.sample_of_vertex, sample);
  return result;
}

}  // namespace geodrome
