// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace geodrome::bench {
namespace {

SurfacePoint random_point_of_kind(const SurfaceMesh& mesh, std::size_t kind, shapes::Random& random) {
  constexpr SurfacePoint (*kinds[])(const SurfaceMesh&, shapes::Random&) = {random_vertex, random_inner_point,
                                                                            random_edge_point};
  return kinds[kind % std::size(kinds)](mesh, random);
}

double mean_edge(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    sum += norm(q - p) + norm(r - q) + norm(p - r);
  }
  return sum / static_cast<double>(3 * mesh.face_count());
}

}  // namespace

SurfacePoint random_inner_point(const SurfaceMesh& mesh, shapes::Random& random) {
  const auto face = static_cast<Index>(random.index(mesh.face_count()));
  // The square root makes the density even over the triangle (Turk 1990).
  const double root = std::sqrt(random.uniform()), along = random.uniform();
  return {face, {1 - root, root * (1 - along), root * along}};
}

SurfacePoint random_edge_point(const SurfaceMesh& mesh, shapes::Random& random) {
  SurfacePoint point{static_cast<Index>(random.index(mesh.face_count())), {}};
  const std::size_t corner = random.index(3);
  point.b[corner] = random.uniform();
  point.b[(corner + 1) % 3] = 1 - point.b[corner];
  return point;
}

SurfacePoint random_vertex(const SurfaceMesh& mesh, shapes::Random& random) {
  const Triangle& face = mesh.triangles()[random.index(mesh.face_count())];
  return mesh.at_vertex(face[random.index(3)]);
}

std::vector<Source> random_sources(const SurfaceMesh& mesh, std::size_t number, shapes::Random& random) {
  constexpr std::size_t kinds = 4;
  if (number % kinds < kinds - 1) return {{random_point_of_kind(mesh, number % kinds, random)}};
  const double latest = 3 * mean_edge(mesh);
  std::vector<Source> sources(2 + random.index(4));
  for (Source& source : sources) {
    source.at = random_point_of_kind(mesh, random.index(kinds - 1), random);
    if (&source == &sources.front()) continue;
    if (random.index(3) == 0) source.at.face = (&source - 1)->at.face;
    if (random.index(3) > 0) source.start = random.uniform(0, latest);
  }
  return sources;
}

bool takes(Provides bits, const SurfaceMesh& mesh, std::span<const Source> sources) {
  return std::ranges::all_of(sources, [&](const Source& source) {
    return (source.start == 0 || has(bits, Provides::start_distances)) &&
           (mesh.vertex_at(source.at) != no_index || has(bits, Provides::face_sources));
  });
}

}  // namespace geodrome::bench
