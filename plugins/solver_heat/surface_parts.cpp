// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/solver_heat/surface_parts.hpp"

#include <algorithm>
#include <cmath>

#include "geodrome/vertex_components.hpp"

namespace geodrome {
namespace {

double mean_edge(const SurfaceMesh& mesh, const std::vector<Index>& faces) {
  const double edges = 3 * static_cast<double>(faces.size());
  double mean = 0;
  for (const Index f : faces) {
    const auto [p, q, r] = mesh.corners(f);
    for (const Vec3& e : {q - p, r - q, p - r}) mean += std::hypot(e.x, e.y, e.z) / edges;
  }
  return mean;
}

}  // namespace

double SurfacePart::original(double length) const { return std::ldexp(length, -exponent); }

SurfaceParts::SurfaceParts(const SurfaceMesh& mesh) : components_(vertex_components(mesh)) {
  places_.resize(mesh.vertex_count());
  std::vector<Index> part_of(mesh.vertex_count(), no_index);  // by the name of the component
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.first_half_edge(v) == no_index) continue;
    Index& part = part_of[components_[v]];
    if (part == no_index) {
      part = static_cast<Index>(parts_.size());
      parts_.emplace_back();
    }
    places_[v] = {part, static_cast<Index>(parts_[part].vertex.size())};
    parts_[part].vertex.push_back(v);
  }
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = mesh.triangles()[f];
    SurfacePart& part = parts_[places_[a].part];
    part.face.push_back(f);
    part.triangles.push_back({places_[a].vertex, places_[b].vertex, places_[c].vertex});
  }
  for (SurfacePart& part : parts_) normalise(part, mesh);
}

void SurfaceParts::normalise(SurfacePart& part, const SurfaceMesh& mesh) {
  const double mean = mean_edge(mesh, part.face);
  const auto refuse = [&](const char* what) {
    throw InputError(InputFault::range, "the component of face " + std::to_string(part.face.front()) + what,
                     "scale the mesh, or leave the component out");
  };
  if (!(mean > 0)) refuse(" has no extent");
  if (!std::isfinite(mean)) refuse(" is beyond the range of numbers");
  part.exponent = -std::ilogb(mean);
  part.mean_edge = std::ldexp(mean, part.exponent);
  part.positions.reserve(part.vertex.size());
  for (const Index v : part.vertex) {
    const Vec3& p = mesh.positions()[v];
    part.positions.push_back(
        {std::ldexp(p.x, part.exponent), std::ldexp(p.y, part.exponent), std::ldexp(p.z, part.exponent)});
    if (!is_finite(part.positions.back())) refuse(" is beyond the range of numbers");
  }
}

std::size_t SurfaceParts::bytes() const {
  std::size_t bytes = components_.size() * sizeof(Index) + places_.size() * sizeof(PlaceInPart);
  for (const SurfacePart& part : parts_)
    bytes +=
        part.vertex.size() * (sizeof(Index) + sizeof(Vec3)) + part.face.size() * (sizeof(Index) + sizeof(Triangle));
  return bytes;
}

}  // namespace geodrome
