// SPDX-License-Identifier: MIT
#include "geodrome/solver_kit/packed_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geodrome/spatial_order.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome {
namespace {

/// Total angles up to this much above 2 pi (pi on the boundary) count as flat. A straight line past a flat vertex and
/// one that bends there by this angle differ in length by its square, so exactness does not suffer; rounding of
/// coordinates makes angles err by less wherever faces are not needles.
constexpr double flat = 1e-12;

/// Rounding moves places on an edge shorter than this share of the bounding box by 1e-5 of its length or more, and
/// turns the direction of a path that bends there as much. So angles cannot say where a path can go on from its ends.
constexpr double no_place = 1e-9;

/// A face with a corner as flat as this (rad) is a segment: straight lines along it cross the edges at no place of
/// their own, so its vertices send on in all directions.
constexpr double no_angle_left = 1e-12;

struct Corner {
  double cosine, sine;
};

Corner corner(const Vec3& p, const Vec3& q) {
  const double along = dot(p, q), across = norm(cross(p, q)), size = std::hypot(along, across);
  return size > 0 ? Corner{along / size, across / size} : Corner{0, 1};
}

}  // namespace

PackedMesh::PackedMesh(MeshPtr mesh) : mesh_(std::move(mesh)) {
  if (3 * mesh_->face_count() >= fan_bit) throw CapabilityError("the mesh has too many faces", "at most 357 million");
  components_ = vertex_components(*mesh_);
  choose_exponent();
  number();
  shape_faces();
  connect();
  list_corners();
  judge_vertices();
}

/// Numbers faces along a Z-order curve by their centres, vertices by the first face that has them, unused ones last.
void PackedMesh::number() {
  const SurfaceMesh& mesh = *mesh_;
  std::vector<Vec3> centres;
  centres.reserve(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    centres.push_back(p / 3 + q / 3 + r / 3);
  }
  original_face_ = spatial_order(centres);
  face_of_original_.resize(mesh.face_count());
  vertex_of_original_.assign(mesh.vertex_count(), no_index);
  original_vertex_.reserve(mesh.vertex_count());
  const auto name = [&](Index v) {
    if (vertex_of_original_[v] != no_index) return;
    vertex_of_original_[v] = static_cast<Index>(original_vertex_.size());
    original_vertex_.push_back(v);
  };
  for (Index f = 0; f < original_face_.size(); ++f) {
    face_of_original_[original_face_[f]] = f;
    for (const Index v : mesh.triangles()[original_face_[f]]) name(v);
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) name(v);
}

void PackedMesh::choose_exponent() {
  double sum = 0;
  std::size_t count = 0;
  for (const auto& [a, b, c] : mesh_->triangles())
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Vec3 edge = mesh_->positions()[q] - mesh_->positions()[p];
      sum += std::hypot(edge.x, edge.y, edge.z), ++count;
    }
  const double mean = count ? sum / static_cast<double>(count) : 0;
  exponent_ = mean > 0 && std::isfinite(mean) ? -std::ilogb(mean) : 0;
}

void PackedMesh::shape_faces() {
  const SurfaceMesh& mesh = *mesh_;
  faces_.resize(mesh.face_count());
  for (Index f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    const auto corners = mesh.corners(original_face_[f]);
    Vec3 edge[3];
    int no_length = -1;
    for (int i = 0; i < 3; ++i) {
      const Vec3 e = corners[(i + 1) % 3] - corners[i];
      edge[i] = {std::ldexp(e.x, exponent_), std::ldexp(e.y, exponent_), std::ldexp(e.z, exponent_)};
      face.length[i] = std::hypot(edge[i].x, edge[i].y, edge[i].z);
      if (face.length[i] == 0) no_length = i;
      face.vertex[i] = vertex_of_original_[mesh.triangles()[original_face_[f]][i]];
      face.across[i] = no_index;
    }
    for (int i = 0; i < 3; ++i) {
      const Corner c = corner(edge[i], -edge[(i + 2) % 3]);
      face.cosine[i] = c.cosine, face.sine[i] = c.sine;
    }
    // A face with an edge without length is a segment: right angles at that edge, none opposite.
    if (no_length >= 0) face.cosine[(no_length + 2) % 3] = 1, face.sine[(no_length + 2) % 3] = 0;
  }
}

void PackedMesh::connect() {
  const auto inner = [this](Index h) { return 3 * face_of_original_[h / 3] + h % 3; };
  if (!mesh_->twins().empty()) {
    for (Index h = 0; h < mesh_->twins().size(); ++h) {
      const Index twin = mesh_->twins()[h];
      if (twin == no_index) continue;
      const Index here = inner(h);
      faces_[here / 3].across[here % 3] = inner(twin) | (mesh_->from(h) == mesh_->from(twin) ? mirror_bit : 0);
    }
    return;
  }
  const auto uses = detail::sorted_edge_uses(mesh_->triangles());
  for (std::size_t i = 0, end = 0; i < uses.size(); i = end) {
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i == 1) continue;
    const auto first = static_cast<Index>(fan_half_edges_.size());
    for (std::size_t k = i; k < end; ++k) {
      const Index h = inner(uses[k].half_edge);
      fan_half_edges_.push_back(h);
      faces_[h / 3].across[h % 3] = fan_bit | static_cast<Index>(fans_.size());
    }
    fans_.emplace_back(first, static_cast<Index>(fan_half_edges_.size()));
  }
  mark_copies();
}

void PackedMesh::mark_copies() {
  std::vector<std::pair<std::array<Index, 3>, Index>> named;
  for (Index f = 0; f < faces_.size(); ++f) {
    std::array<Index, 3> vertices{faces_[f].vertex[0], faces_[f].vertex[1], faces_[f].vertex[2]};
    std::sort(vertices.begin(), vertices.end());
    named.emplace_back(vertices, f);
  }
  std::sort(named.begin(), named.end());
  copies_.assign(faces_.size(), false);
  for (std::size_t i = 1; i < named.size(); ++i)
    if (named[i].first == named[i - 1].first) copies_[named[i].second] = true;
  for (const auto& [first, last] : fans_) {
    const auto is_no_copy = [this](Index h) { return !copies_[h / 3]; };
    branching_.push_back(std::count_if(fan_half_edges_.begin() + first, fan_half_edges_.begin() + last, is_no_copy) >
                         2);
  }
}

void PackedMesh::list_corners() {
  first_corner_.assign(vertex_count() + 1, 0);
  for (const Face& face : faces_)
    for (const Index v : face.vertex) ++first_corner_[v + 1];
  for (std::size_t v = 0; v < vertex_count(); ++v) first_corner_[v + 1] += first_corner_[v];
  corners_.resize(3 * faces_.size());
  std::vector<Index> end(first_corner_.begin(), first_corner_.end() - 1);
  for (Index h = 0; h < corners_.size(); ++h) corners_[end[from(h)]++] = h;
}

/// Puts the corners of a vertex into counterclockwise order, if they are one fan of oriented faces with at most two to
/// an edge; `regular` stays false otherwise.
void PackedMesh::order_corners(Index vertex, std::vector<bool>& regular) {
  const auto oriented_twin = [this](Index h) {
    const Index code = faces_[h / 3].across[h % 3];
    if (code == no_index || !(code & (mirror_bit | fan_bit))) return code;
    if (code & mirror_bit) return no_index;
    const auto& [first, last] = fans_[code & ~fan_bit];
    if (last - first != 2) return no_index;
    const Index other = fan_half_edges_[first] == h ? fan_half_edges_[first + 1] : fan_half_edges_[first];
    return from(other) == from(h) ? no_index : other;
  };
  const std::span<Index> corners(corners_.data() + first_corner_[vertex],
                                 first_corner_[vertex + 1] - first_corner_[vertex]);
  if (corners.empty()) return;
  Index start = corners[0];
  for (const Index h : corners)
    if (faces_[h / 3].across[h % 3] == no_index) start = h;
  std::vector<Index> turn;
  for (Index h = start; h != no_index && turn.size() <= corners.size();) {
    turn.push_back(h);
    const Index before = SurfaceMesh::previous(h);
    h = oriented_twin(before);
    if (h == start) break;
    if (h == no_index && faces_[before / 3].across[before % 3] != no_index) return;
  }
  if (turn.size() != corners.size()) return;
  std::copy(turn.begin(), turn.end(), corners.begin());
  regular[vertex] = true;
}

void PackedMesh::judge_vertices() {
  std::vector<bool> regular(vertex_count(), false), in_no_area(vertex_count(), false);
  for (Index v = 0; v < vertex_count(); ++v) order_corners(v, regular);

  Vec3 low{INFINITY, INFINITY, INFINITY}, high = -low;
  for (const Vec3& p : mesh_->positions()) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double shortest = no_place * std::ldexp(std::hypot(high.x - low.x, high.y - low.y, high.z - low.z), exponent_);
  for (const Face& face : faces_)
    for (int i = 0; i < 3; ++i)
      if (face.length[i] <= shortest) in_no_area[face.vertex[i]] = in_no_area[face.vertex[(i + 1) % 3]] = true;
  for (const Face& face : faces_)
    for (int i = 0; i < 3; ++i)
      if (face.cosine[i] < 0 && face.sine[i] <= no_angle_left)
        for (const Index v : face.vertex) in_no_area[v] = true;

  kind_.assign(vertex_count(), VertexKind::irregular);
  for (Index v = 0; v < vertex_count(); ++v) {
    if (!regular[v] || in_no_area[v]) continue;
    double angle = 0;
    for (const Index h : corners(v)) angle += std::atan2(face_of(h).sine[h % 3], face_of(h).cosine[h % 3]);
    const Index first = corners(v).front();
    const bool open = face_of(first).across[first % 3] == no_index;
    const bool bends = angle > (open ? 1 : 2) * std::numbers::pi + flat;
    kind_[v] = !bends ? VertexKind::smooth : open ? VertexKind::open_saddle : VertexKind::saddle;
  }
}

std::size_t PackedMesh::bytes() const {
  return faces_.size() * sizeof(Face) + copies_.size() / 8 + fans_.size() * sizeof(fans_[0]) + kind_.size() +
         sizeof(Index) *
             (fan_half_edges_.size() + first_corner_.size() + corners_.size() + vertex_of_original_.size() +
              original_vertex_.size() + face_of_original_.size() + original_face_.size() + components_.size());
}

}  // namespace geodrome
