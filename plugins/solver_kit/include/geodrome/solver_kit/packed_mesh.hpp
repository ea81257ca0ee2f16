// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geodrome/surface.hpp"

namespace geodrome {

/// A mesh packed for searches across faces: every face with its lengths, angles and neighbours in one piece of memory,
/// faces and vertices along a space-filling curve, lengths multiplied by a power of two so that the mean edge is about
/// 1 long. Any mesh: edges with more than two faces and faces that run the same way along an edge too. Immutable;
/// thread-safe. About 130 bytes a face.
///
/// Half-edge 3 f + i runs from corner i of face f to corner i + 1. Its frame has the origin at its start, x along it,
/// and the face at y >= 0. Faces and vertices have numbers of their own here; corners keep their order. Indices are not
/// checked.
class PackedMesh {
 public:
  struct alignas(32) Face {     // two cache lines, wherever it stands
    double length[3];           ///< of half-edge i
    double cosine[3], sine[3];  ///< of the angle at corner i
    Index vertex[3];
    Index across[3];  ///< see for_each_across
  };

  /// Packs a mesh. O(F log F). Throws CapabilityError for a mesh of 2^30 half-edges or more.
  explicit PackedMesh(MeshPtr mesh);

  const SurfaceMesh& mesh() const { return *mesh_; }
  const MeshPtr& mesh_pointer() const { return mesh_; }
  std::size_t vertex_count() const { return original_vertex_.size(); }
  std::size_t face_count() const { return faces_.size(); }
  const Face& face(Index f) const { return faces_[f]; }
  const Face& face_of(Index half_edge) const { return faces_[half_edge / 3]; }

  Index from(Index h) const { return faces_[h / 3].vertex[h % 3]; }
  double length(Index h) const { return faces_[h / 3].length[h % 3]; }

  /// Returns what a unit of length costs in a face: 1 unless the mesh has weights.
  double weight(Index f) const {
    const auto weights = mesh_->face_weights();
    return weights.empty() ? 1 : weights[original_face_[f]];
  }

  double longest_side(Index f) const {
    return std::max({faces_[f].length[0], faces_[f].length[1], faces_[f].length[2]});
  }

  /// Calls `visit(other, mirrored)` for every other half-edge on the edge of `h`: none on the boundary, one inside,
  /// more where more than two faces meet. Mirrored: both run the same way.
  template <class Visit>
  void for_each_across(Index h, Visit&& visit) const {
    const Index code = faces_[h / 3].across[h % 3];
    if (code == no_index) return;
    if (code & fan_bit) {
      const auto& [first, last] = fans_[code & ~fan_bit];
      for (Index i = first; i < last; ++i)
        if (fan_half_edges_[i] != h) visit(fan_half_edges_[i], from(fan_half_edges_[i]) == from(h));
      return;
    }
    visit(code & ~mirror_bit, (code & mirror_bit) != 0);
  }

  /// The only other half-edge on edge i of a face; none on the boundary and where more than two faces meet.
  struct Across {
    Index half_edge = no_index;
    bool mirrored = false;  ///< both run the same way
  };
  static Across only_across(const Face& face, int i) {
    const Index code = face.across[i];
    if (code == no_index || (code & fan_bit)) return {};
    return {code & ~mirror_bit, (code & mirror_bit) != 0};
  }

  /// Tells whether more than two faces meet at the edge of `h`.
  bool is_fan(Index h) const {
    const Index code = faces_[h / 3].across[h % 3];
    return code != no_index && (code & fan_bit) && fans_[code & ~fan_bit].second - fans_[code & ~fan_bit].first > 2;
  }
  /// Tells whether more than two faces that are no copies (`is_copy`) meet at the edge of `h`: what comes through one
  /// of them goes on into several.
  bool branches(Index h) const { return is_fan(h) && branching_[fan(h)]; }
  /// Returns the number of an edge at which more than two faces meet. Precondition: `is_fan`. Numbers are below
  /// `fan_count()`; not all of them are used.
  Index fan(Index h) const { return faces_[h / 3].across[h % 3] & ~fan_bit; }
  std::size_t fan_count() const { return fans_.size(); }

  /// Tells whether a face has the vertices of one with a lower number. The two are congruent, so no shortest path needs
  /// to cross this one; paths may begin and end in it.
  bool is_copy(Index f) const { return !copies_.empty() && copies_[f]; }

  /// Returns the place of a point in the frame of half-edge `h` of its face; `b` counts from corner 0 of the face.
  std::pair<double, double> in_frame(Index h, const std::array<double, 3>& b) const {
    const Face& face = face_of(h);
    const int i = static_cast<int>(h % 3), j = (i + 1) % 3, k = (i + 2) % 3;
    const auto [x, y] = apex(face, i);
    return {b[j] * face.length[i] + b[k] * x, b[k] * y};
  }
  /// Returns place x of half-edge `h` as a point of its face, with the face number here; beyond an end, the end.
  SurfacePoint point_on(Index h, double x) const {
    const double length = this->length(h), share = length > 0 ? std::clamp(x / length, 0.0, 1.0) : 0;
    SurfacePoint point{h / 3, {}};
    point.b[h % 3] = 1 - share;
    point.b[(h + 1) % 3] = share;
    return point;
  }
  /// Returns the place of the third corner in the frame of half-edge i of a face.
  static std::pair<double, double> apex(const Face& face, int i) {
    const double side = face.length[(i + 2) % 3];
    return {side * face.cosine[i], side * face.sine[i]};
  }

  /// Calls `visit(point)` for every face that holds `point`, which is no vertex, with the name of the point there, a
  /// face and barycentric coordinates: its own face first, then the others on its edge. Face numbers are those here.
  template <class Visit>
  void for_each_name(const SurfacePoint& point, Visit&& visit) const {
    visit(point);
    for (Index i = 0; i < 3; ++i) {
      if (point.b[i] != 0) continue;
      for_each_across(3 * point.face + (i + 1) % 3, [&](Index other, bool mirrored) {
        SurfacePoint there{other / 3, {}};
        there.b[other % 3] = point.b[(i + (mirrored ? 1 : 2)) % 3];
        there.b[(other + 1) % 3] = point.b[(i + (mirrored ? 2 : 1)) % 3];
        visit(there);
      });
    }
  }

  /// Returns the half-edges that start at a vertex, one for each face around it; counterclockwise unless the vertex is
  /// `irregular`.
  std::span<const Index> corners(Index vertex) const {
    return {corners_.data() + first_corner_[vertex], corners_.data() + first_corner_[vertex + 1]};
  }

  /// The behaviour of shortest paths at a vertex.
  enum class VertexKind : std::uint8_t {
    smooth,       ///< never bend there: total angle <= 2 pi, or on the boundary and <= pi
    saddle,       ///< may bend there; its corners go once around it
    open_saddle,  ///< the same on the boundary; its corners go from one boundary edge to the other
    irregular     ///< several fans, more than two faces on an edge, unoriented, an edge too short or a face too flat
  };
  VertexKind kind(Index vertex) const { return kind_[vertex]; }

  Index vertex_of_original(Index v) const { return vertex_of_original_[v]; }
  Index original_vertex(Index v) const { return original_vertex_[v]; }
  Index face_of_original(Index f) const { return face_of_original_[f]; }
  Index original_face(Index f) const { return original_face_[f]; }
  /// Translate a surface point of the mesh to the face number here, and back.
  SurfacePoint inner(const SurfacePoint& p) const { return {face_of_original_[p.face], p.b}; }
  SurfacePoint original(const SurfacePoint& p) const { return {original_face_[p.face], p.b}; }

  /// Returns the exponent of the scale: lengths here are those of the mesh times 2^exponent.
  int exponent() const { return exponent_; }
  /// Returns the component of every vertex, by the vertex numbers of the mesh itself (vertex_components).
  const std::vector<Index>& components() const { return components_; }
  std::size_t bytes() const;

 private:
  static constexpr Index mirror_bit = Index{1} << 31, fan_bit = Index{1} << 30;

  void number();
  void choose_exponent();
  void shape_faces();
  void connect();
  void mark_copies();
  void list_corners();
  void order_corners(Index vertex, std::vector<bool>& regular);
  void judge_vertices();

  MeshPtr mesh_;
  int exponent_ = 0;
  std::vector<Face> faces_;
  std::vector<std::pair<Index, Index>> fans_;
  std::vector<Index> fan_half_edges_;
  std::vector<bool> copies_, branching_;  ///< of faces, of fans; empty if no edge has more than one other face
  std::vector<Index> first_corner_, corners_;
  std::vector<VertexKind> kind_;
  std::vector<Index> vertex_of_original_, original_vertex_, face_of_original_, original_face_;
  std::vector<Index> components_;
};

}  // namespace geodrome
