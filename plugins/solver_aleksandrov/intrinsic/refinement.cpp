// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "plugins/solver_aleksandrov/intrinsic/delaunay.hpp"

namespace geodrome::aleksandrov {
namespace {

class Refiner {
 public:
  Refiner(IntrinsicTriangulation& triangulation, double least_angle, Index most, const RunContext& context)
      : t_(triangulation),
        context_(context),
        least_sine_(std::sin(least_angle)),
        first_(triangulation.vertex_count()),
        most_(first_ + most),
        scale_(first_, infinity) {
    for (Index f = 0; f < t_.face_count(); ++f)
      for (int i = 0; i < 3; ++i) {
        double& scale = scale_[t_.face(f).vertex[i]];
        scale = std::min(scale, to_opposite_side(t_.face(f), i));
      }
  }

  void run() {
    for (Index f = 0; f < t_.face_count(); ++f) consider(f);
    for (std::size_t step = 1; !bad_.empty() && t_.vertex_count() < most_; ++step) {
      if (step % 256 == 0) context_.throw_if_cancelled();
      const Bad bad = bad_.top();
      bad_.pop();
      if (bad.sine == judge(bad.face).sine) improve(bad.face);
    }
  }

 private:
  struct Bad {
    double sine;  ///< of the smallest angle
    Index face;
    bool operator<(const Bad& other) const { return sine > other.sine || (sine == other.sine && face > other.face); }
  };

  double angle(Index h) const { return std::atan2(t_.face(h / 3).sine[h % 3], t_.face(h / 3).cosine[h % 3]); }

  /// Whether the surface itself has a small angle at the start of `h`: all the way around, or from one edge that cannot
  /// be flipped to the next. No vertices can make that wider.
  bool is_sharp(Index h) const {
    double whole = angle(h);
    Index c = h;
    for (Index g; whole < sharp && (g = t_.flat_twin(SurfaceMesh::previous(c))) != no_index; whole += angle(c))
      if ((c = g) == h) return true;
    c = h;
    for (Index g; whole < sharp && (g = t_.flat_twin(c)) != no_index; whole += angle(c)) c = SurfaceMesh::next(g);
    return whole < sharp;
  }

  /// The sine of the smallest angle; 1 if the face is good, or no vertex can make it better.
  Bad judge(Index f) const {
    const auto& face = t_.face(f);
    const int i = static_cast<int>(std::min_element(face.length, face.length + 3) - face.length), apex = (i + 2) % 3;
    const double sine = face.cosine[apex] > 0 ? face.sine[apex] : 1;
    if (sine >= least_sine_) return {1, f};
    if (face.length[i] < std::max(smallest_share * scale_of(f), no_length)) return {1, f};
    return {is_sharp(3 * f + static_cast<Index>(apex)) ? 1 : sine, f};
  }

  double scale_of(Index f) const {
    const auto& vertex = t_.face(f).vertex;
    return std::min({scale_[vertex[0]], scale_[vertex[1]], scale_[vertex[2]]});
  }

  void consider(Index f) {
    const Bad bad = judge(f);
    if (bad.sine < 1) bad_.push(bad);
  }

  /// Puts a vertex at the centre of the circle around a face, or on the edge in its way.
  void improve(Index f) {
    const auto& face = t_.face(f);
    const auto longest = std::max_element(face.length, face.length + 3) - face.length;
    const Index base = 3 * f + static_cast<Index>(longest);
    const Point2 top = t_.apex(base);
    // A segment: there is no such circle.
    if (t_.flat_twin(base) == no_index && face.cosine[(longest + 2) % 3] < flat_cosine) return split(base, top.x);
    const auto shortest = std::min_element(face.length, face.length + 3) - face.length;
    Index h = 3 * f + static_cast<Index>(shortest);
    const double half = t_.length(h) / 2, sine = std::max(face.sine[(shortest + 2) % 3], least_sine);
    Point2 p{half, half * face.cosine[(shortest + 2) % 3] / sine};
    for (int step = 0; step < 1000; ++step) {
      const Index way_out = edge_before(h, p);
      if (way_out == no_index) return insert(h, p);
      const Index g = t_.flat_twin(way_out);
      if (g == no_index) return split_in_two(way_out);
      for (; h != way_out; h = SurfaceMesh::next(h)) p = t_.in_next_frame(h, p);
      p = {t_.length(h) - p.x, -p.y}, h = g;
    }
  }

  /// The half-edge of the face of `h` that separates it from `p`, which is in the frame of `h`.
  Index edge_before(Index h, Point2 p) const {
    Index worst = no_index;
    double depth = 0;
    for (int i = 0; i < 3; ++i) {
      if (p.y < depth) depth = p.y, worst = h;
      p = t_.in_next_frame(h, p), h = SurfaceMesh::next(h);
    }
    return worst;
  }

  /// A vertex in the face of `h`, unless it would come too near to one of its edges that cannot be flipped: inside the
  /// circle that has the edge as diameter. Such an edge is split instead.
  void insert(Index h, Point2 p) {
    Point2 q = p;
    for (int i = 0; i < 3; ++i) {
      const double whole = t_.length(h);
      if (t_.flat_twin(h) == no_index && q.x * (q.x - whole) + q.y * q.y < 0) return split_in_two(h);
      q = t_.in_next_frame(h, q), h = SurfaceMesh::next(h);
    }
    const Index first = t_.face_count(), f = h / 3;
    scale_.push_back(scale_of(f));
    t_.split_face(h, p);
    changed_.assign(1, f);
    settle(first);
  }

  /// An edge that cannot be flipped. Not where it ends in a sharp corner: such edges would split each other for ever,
  /// and between two edges of the boundary there would be angles that need Steiner points where now are none.
  void split_in_two(Index h) {
    Index g = h;
    do
      if (is_sharp(g) || is_sharp(SurfaceMesh::next(g))) return;
    while ((g = t_.next_on_edge(g)) != h);
    split(h, t_.length(h) / 2);
  }

  void split(Index h, double x) {
    const Index first = t_.face_count();
    changed_.assign(1, h / 3);
    for (Index g = t_.next_on_edge(h); g != h; g = t_.next_on_edge(g)) changed_.push_back(g / 3);
    const double scale = scale_of(h / 3);
    if (t_.split_edge(h, x) == no_index) return;
    scale_.push_back(scale);
    settle(first);
  }

  /// Restores the Delaunay property around faces that changed and new ones, and looks at all that became of them.
  void settle(Index first_new_face) {
    for (Index f = first_new_face; f < t_.face_count(); ++f) changed_.push_back(f);
    for (const Index f : changed_)
      for (Index i = 0; i < 3; ++i) stack_.push_back(3 * f + i);
    flip_until_delaunay(t_, stack_, changed_, context_);
    for (const Index f : changed_) consider(f);
  }

  /// Around a vertex with a small total angle circles overlap themselves, and refinement would not end.
  static constexpr double smallest_share = 1.0 / 32;
  /// Shorter than what edges without length are given is made of rounding, and refinement would follow that for ever.
  static constexpr double no_length = 9e-15;
  static constexpr double sharp = std::numbers::pi / 3;
  static constexpr double flat_cosine = -0.999, least_sine = 1e-15;

  IntrinsicTriangulation& t_;
  const RunContext& context_;
  double least_sine_;
  Index first_, most_;         ///< inserted vertices: numbers and bound
  std::vector<double> scale_;  ///< the size of the smallest thing near a vertex before refinement
  std::priority_queue<Bad> bad_;
  std::vector<Index> stack_, changed_;
};

}  // namespace

Index refine(IntrinsicTriangulation& triangulation, double least_angle, Index most, const RunContext& context) {
  const Index before = triangulation.vertex_count();
  Refiner(triangulation, least_angle, most, context).run();
  return triangulation.vertex_count() - before;
}

}  // namespace geodrome::aleksandrov
