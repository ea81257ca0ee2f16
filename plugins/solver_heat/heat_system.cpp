// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_heat/heat_system.hpp"

#define CGAL_EIGEN3_ENABLED

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Method = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;

/// How much longer than the third two sides of a face must be together, relative to the longest. CGAL takes angles from
/// the lengths, by Heron's formula, which loses the digits of that difference. With none left it may flip edges for
/// ever or give distances that are off by their own size; here about four are left.
constexpr double least_excess = 1e-12;

/// What CGAL adds to all lengths if there is a face without area, relative to the shortest edge.
constexpr double mollified = 1e-4;

/// Heat falls by a factor of e or a little less in a mean edge; after so many it nears the end of the range of
/// numbers, beyond which it has no direction.
constexpr double farthest_heat = 690;

/// How much faster than 1 a result may rise along an edge. On 1,500 random meshes whose mean error was below 10 % none
/// rose faster than 2.9; above this some were off by 15 % on average and most by 30 to 600 %.
constexpr double steepest = 4;

/// Edges shorter than this share of the mean do not count alone: there smoothing may tilt a result as it likes.
constexpr double no_edge = 1e-3;

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

/// A vertex and its distance from a source along edges.
struct Farthest {
  Index vertex;
  double distance;
};
Farthest farthest_along_edges(const Mesh& mesh, Index source) {
  std::vector<double> distances(mesh.number_of_vertices());
  const auto index = get(boost::vertex_index, mesh);
  boost::dijkstra_shortest_paths(
      mesh, Mesh::Vertex_index(source),
      boost::vertex_index_map(index).distance_map(boost::make_iterator_property_map(distances.begin(), index)));
  const auto last = std::max_element(distances.begin(), distances.end());
  return {static_cast<Index>(last - distances.begin()), *last};
}

/// Judges what CGAL made of the heat of a source.
class Verdict {
 public:
  Verdict(const SurfacePart& part, const Mesh& mesh, Index source) : part_(part), mesh_(mesh), source_(source) {}

  /// Throws NumericalError unless scaled distances are numbers within the reach of heat that rise as distances do.
  void require_distances(const std::vector<double>& distances) const {
    for (Index v = 0; v < distances.size(); ++v) {
      if (!(distances[v] < std::numeric_limits<double>::max()))  // what CGAL makes of NaN
        refuse_unfit(v, "CGAL's result is no number");
      if (distances[v] > farthest_heat * part_.mean_edge) refuse(v, "it is more than 690 mean edges away", coarser);
    }
    for (const Triangle& t : part_.triangles) {
      const auto lengths = sides(part_, t);
      for (int i = 0; i < 3; ++i) {
        const double rise = std::abs(distances[t[(i + 1) % 3]] - distances[t[i]]);
        if (rise > steepest * (lengths[i] + no_edge * part_.mean_edge))
          refuse_unfit(t[i], "along an edge CGAL's result rises faster than any distance");
      }
    }
  }

 private:
  static constexpr const char* coarser = "make the mesh coarser, or choose another solver";

  [[noreturn]] void refuse(Index v, const std::string& why, const char* remedy) const {
    throw NumericalError("the heat of vertex " + std::to_string(part_.vertex[source_]) +
                             " gives no distance of vertex " + std::to_string(part_.vertex[v]) + ": " + why,
                         remedy);
  }

  /// Names the cause. Where heat is below the range of numbers it has no direction, and what CGAL divides by it spoils
  /// the distances of all vertices, the nearest too; the vertex named is then the farthest one.
  [[noreturn]] void refuse_unfit(Index v, const std::string& why) const {
    const Farthest farthest = farthest_along_edges(mesh_, source_);
    const double edges = farthest.distance / part_.mean_edge;
    if (!(edges > farthest_heat)) refuse(v, why, "remesh needle faces, or choose another solver");
    refuse(farthest.vertex,
           "it is " + std::to_string(std::lround(edges)) +
               " mean edges away along edges, and heat, which falls by about e in each, leaves the range of numbers "
               "after 690; then no distance is right",
           coarser);
  }

  const SurfacePart& part_;
  const Mesh& mesh_;
  Index source_;
};

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
  for (Index v = 0; v < distances_.size(); ++v) distances_[v] = cgal_->distance[Mesh::Vertex_index(v)];
  distances_[source] = 0;
  Verdict(part_, cgal_->mesh, source).require_distances(distances_);
  for (double& distance : distances_) distance = part_.original(distance);
  return distances_;
}

}  // namespace geodrome
