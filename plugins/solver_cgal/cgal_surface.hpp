// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geodrome/surface.hpp"
#include "plugins/solver_cgal/layout_traits.hpp"

namespace geodrome::cgal {

/// The power of two that brings `length` to [1, 2), as an exponent; 0 for 0. Scaling by it changes no digit.
inline int normalising_exponent(double length) { return length > 0 ? -std::ilogb(length) : 0; }

/// How a mesh is moved and scaled for CGAL, whose tolerances are absolute: y = (x - shift) * 2^exponent.
/// The mean edge becomes about 1 long. The shift is a multiple of twice the extent's power of two: 0 for a mesh that is
/// near the origin, and exact to subtract for one that is far away.
struct Normalisation {
  Vec3 shift;
  int exponent = 0;

  explicit Normalisation(const SurfaceMesh& mesh) {
    if (mesh.face_count() == 0) return;
    Vec3 low = mesh.positions()[mesh.triangles()[0][0]], high = low;
    for (const Triangle& t : mesh.triangles())
      for (const Index v : t) {
        const Vec3& p = mesh.positions()[v];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
      }
    const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    if (!(extent > 0) || !std::isfinite(extent))
      throw InputError(InputFault::range, "the mesh's extent is zero or beyond the range of numbers", "scale the mesh");
    const int step = std::ilogb(extent) + 2;
    const auto snap = [step](double a, double b) {
      return std::ldexp(std::round(std::ldexp(a / 2 + b / 2, -step)), step);
    };
    shift = {snap(low.x, high.x), snap(low.y, high.y), snap(low.z, high.z)};
    exponent = normalising_exponent(mean_edge(mesh));
  }

  Vec3 apply(const Vec3& p) const {
    const Vec3 d = p - shift;
    return {std::ldexp(d.x, exponent), std::ldexp(d.y, exponent), std::ldexp(d.z, exponent)};
  }
  double original(double length) const { return std::ldexp(length, -exponent); }

 private:
  static double mean_edge(const SurfaceMesh& mesh) {
    double sum = 0;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto [p, q, r] = mesh.corners(f);
      for (const Vec3& e : {q - p, r - q, p - r})
        sum += std::hypot(e.x, e.y, e.z) / (3.0 * static_cast<double>(mesh.face_count()));
    }
    return sum;
  }
};

/// CGAL's copy of a mesh: same vertex and face numbers, and every face's first half-edge runs from its corner 0, so
/// that barycentric coordinates mean the same. Throws CapabilityError if CGAL refuses a face.
inline Mesh copy_for_cgal(const SurfaceMesh& mesh, const Normalisation& normalisation) {
  Mesh copy;
  copy.reserve(static_cast<Mesh::size_type>(mesh.vertex_count()), static_cast<Mesh::size_type>(3 * mesh.face_count()),
               static_cast<Mesh::size_type>(mesh.face_count()));
  for (const Vec3& p : mesh.positions()) {
    const Vec3 q = normalisation.apply(p);
    copy.add_vertex(Kernel::Point_3(q.x, q.y, q.z));
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = mesh.triangles()[f];
    const auto face = copy.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
    if (face == Mesh::null_face())
      throw CapabilityError("CGAL refuses face " + std::to_string(f), "the mesh must be manifold and oriented");
    copy.set_halfedge(face, copy.halfedge(Mesh::Vertex_index(a), Mesh::Vertex_index(b)));
  }
  return copy;
}

}  // namespace geodrome::cgal
