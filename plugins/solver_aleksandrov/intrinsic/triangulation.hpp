// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "geodrome/solver_kit/packed_mesh.hpp"
#include "plugins/solver_aleksandrov/intrinsic/plane.hpp"
#include "plugins/solver_aleksandrov/intrinsic/rearrangements.hpp"

namespace geodrome::aleksandrov {

/// A triangulation of a polyhedral surface whose edges are straight on the surface but need not be edges of the mesh:
/// lengths and angles are all it knows (Fisher et al. 2007; Sharp, Soliman and Crane 2019). It begins as the mesh and
/// changes by flips and splits; the surface, and with it every distance, stays what it is.
///
/// Half-edge 3 f + i runs from corner i of face f to corner i + 1, the face on its left. The half-edges of an edge are
/// a ring: one on the boundary, two inside, more where more faces meet. An edge may have the same vertex at both ends.
/// Vertices keep the numbers of the flat surface, then come those that were inserted.
class IntrinsicTriangulation {
 public:
  struct Face {
    std::array<Index, 3> vertex;
    double length[3];           ///< of half-edge i
    double cosine[3], sine[3];  ///< of the angle at corner i
  };

  /// The mesh as it is, in the units of the flat surface. `tiny` > 0 is the length given to edges without one. O(F).
  IntrinsicTriangulation(const PackedMesh& surface, double tiny);

  Index face_count() const { return static_cast<Index>(faces_.size()); }
  Index vertex_count() const { return vertex_count_; }
  const Face& face(Index f) const { return faces_[f]; }
  double weight(Index f) const { return weights_.empty() ? 1 : weights_[f]; }
  bool weighted() const { return !weights_.empty(); }
  Index from(Index h) const { return faces_[h / 3].vertex[h % 3]; }
  double length(Index h) const { return faces_[h / 3].length[h % 3]; }

  /// The next half-edge of the ring around an edge; itself on the boundary.
  Index next_on_edge(Index h) const { return next_on_edge_[h]; }
  /// Whether two half-edges of a ring run the same way.
  bool same_way(Index g, Index h) const { return forward_[g] == forward_[h]; }

  bool forward(Index h) const { return forward_[h]; }

  /// The apex of the face in the frame of a half-edge: origin at its start, x along it, the face above.
  Point2 apex(Index h) const;
  /// A point from the frame of a half-edge in that of the next of its face.
  Point2 in_next_frame(Index h, Point2 p) const;

  /// The half-edge on the other side of an edge where the surface is flat across it: exactly two faces, different ones,
  /// oriented alike and of the same weight; no_index elsewhere. Such edges may be flipped, and lines go straight on.
  Index flat_twin(Index h) const;

  /// Replaces an edge by the other diagonal of the two triangles at it. Precondition: it has a flat twin, and the
  /// angles opposite to it have a sum above pi. Its half-edges are 3 f and 3 g afterwards.
  void flip(Index h);
  /// Puts a vertex into the inside of the face of `h`, at `p` in the frame of `h`, and returns it.
  Index split_face(Index h, Point2 p);
  /// Puts a vertex on an edge, `x` from the start of `h`, and returns it; no_index, and nothing is done, where a face
  /// has the edge twice.
  Index split_edge(Index h, double x);

  /// A place of the flat surface here; an edge or corner that is left is hit exactly.
  SurfacePoint located(const SurfacePoint& flat) const;
  /// Appends the straight way between two places of a face here as pieces in faces of the flat surface.
  void restore(Index f, const Barycentric& from, const Barycentric& to, std::vector<Piece>& out) const;

  std::size_t bytes() const;

 private:
  struct Ring {
    Index half_edge, next;
    bool forward;
  };

  void connect(const PackedMesh& surface);
  void lengthen(double tiny);
  void lay_out(Index f, const std::array<Index, 3>& vertex, const Triangle2& corners);
  void join(Index g, Index h);
  /// Gives half-edges new numbers in their rings: `renamed[i]` = {old, new}.
  template <std::size_t n>
  void rename(const std::array<std::pair<Index, Index>, n>& renamed);
  Index add_face(Index like);
  void record(const Rearrangement& change, std::initializer_list<Index> faces);

  Index vertex_count_;
  std::vector<Face> faces_;
  std::vector<double> weights_;  ///< empty: all 1
  std::vector<Index> next_on_edge_;
  std::vector<bool> forward_;
  std::vector<Index> triangle_of_face_, face_of_triangle_;  ///< numbers in the record
  Rearrangements past_;
};

/// The distance from corner i of a face to the side opposite to it.
double to_opposite_side(const IntrinsicTriangulation::Face& face, int i);

}  // namespace geodrome::aleksandrov
