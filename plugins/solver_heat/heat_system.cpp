// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_heat/heat_system.hpp"

#define CGAL_EIGEN3_ENABLED

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Method = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;

/// How much longer than the third two sides of a face must be together, relative to the longest. CGAL takes angles from
/// the lengths, by Heron's formula, which loses the digits of that difference; with none left it flips edges for ever.
/// Here about four are left.
constexpr double least_excess = 1e-12;

/// What CGAL adds to all lengths if there is a face without area, relative to the shortest edge.
constexpr double mollified = 1e-4;

/// Heat falls by a factor of e or a little less in a mean edge; after so many it nears the end of the range of
/// numbers, beyond which it has no direction.
constexpr double farthest_heat = 690;

std::array<double, 3> sides(const SurfacePart& part, const Triangle& t) {
  const auto length = [&](int i) { return norm(part.positions[t[(i + 1) % 3]] - part.positions[t[i]]); };
  return {length(0), length(1), length(2)};
}

double excess(const std::array<double, 3>& s) { return s[0] + s[1] + s[2] - 2 * std::max({s[0], s[1], s[2]}); }

/// What CGAL will add to every length of this part.
double mollification(const SurfacePart& part) {
  double shortest = std::numeric_limits<double>::max(), least = shortest;
  bool degenerate = false;
  for (const Triangle& t : part.triangles) {
    const Vec3 p = part.positions[t[0]];
    const Vec3 normal = cross(part.positions[t[1]] - p, part.positions[t[2]] - p);
    degenerate = degenerate || !(dot(normal, normal) > 0);
    const auto lengths = sides(part, t);
    least = std::min(least, excess(lengths));
    for (const double length : lengths)
      if (length > 0) shortest = std::min(shortest, length);
  }
  return degenerate ? std::max(0.0, mollified * shortest - least) : 0;
}

void require_angles(const SurfacePart& part) {
  const double more = mollification(part);
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto lengths = sides(part, part.triangles[i]);
    if (excess(lengths) + more >= least_excess * (std::max({lengths[0], lengths[1], lengths[2]}) + more)) continue;
    throw NumericalError("face " + std::to_string(part.face[i]) + " is too flat for its angles to be known",
                         "remesh, or choose another solver");
  }
}

Mesh copy_for_cgal(const SurfacePart& part) {
  Mesh copy;
  for (const Vec3& p : part.positions) copy.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
  for (std::size_t i = 0; i < part.triangles.size(); ++i) {
    const auto [a, b, c] = part.triangles[i];
    if (copy.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c)) == Mesh::null_face())
      throw CapabilityError("CGAL refuses face " + std::to_string(part.face[i]),
                            "the mesh must be manifold and oriented");
  }
  return copy;
}

}  // namespace

struct HeatSystem::Cgal {
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, double> distance;
  Method method;

  explicit Cgal(const SurfacePart& part)
      : mesh(copy_for_cgal(part)),
        distance(mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first),
        method(mesh) {}
};

HeatSystem::HeatSystem(const SurfacePart& part) : part_(part), distances_(part.vertex.size()) {
  require_angles(part);
  cgal_ = guarded([&] { return std::make_unique<Cgal>(part); });
}

HeatSystem::~HeatSystem() = default;

const std::vector<double>& HeatSystem::from(Index source) {
  guarded([&] {
    cgal_->method.clear_sources();
    cgal_->method.add_source(Mesh::Vertex_index(source));
    cgal_->method.estimate_geodesic_distances(cgal_->distance);
  });
  const auto refuse = [&](Index v, const char* why, const char* remedy) {
    throw NumericalError("the heat of vertex " + std::to_string(part_.vertex[source]) + " does not come to vertex " +
                             std::to_string(part_.vertex[v]) + ": " + why,
                         remedy);
  };
  for (Index v = 0; v < distances_.size(); ++v) {
    const double distance = cgal_->distance[Mesh::Vertex_index(v)];
    if (!std::isfinite(distance))
      refuse(v, "CGAL's result is no number", "remesh needle faces, or choose another solver");
    if (distance > farthest_heat * part_.mean_edge)
      refuse(v, "it is more than 690 mean edges away", "make the mesh coarser, or choose another solver");
    distances_[v] = part_.original(distance);
  }
  distances_[source] = 0;
  return distances_;
}

}  // namespace geodrome
