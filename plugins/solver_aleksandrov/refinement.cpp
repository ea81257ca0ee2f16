// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "solver_aleksandrov/delaunay.hpp"

namespace geodrome::aleksandrov {
namespace {

class Refiner {
 public:
  Refiner(IntrinsicTriangulation& triangulation, double least_angle, Index most, const RunContext& context)
      : t_(triangulation),
        context_(context),
        least_sine_(std::sin(least_angle)),
        most_(triangulation.vertex_count() + most),
        whole_(triangulation.vertex_count(), 0) {
    for (Index f = 0; f < t_.face_count(); ++f)
      for (int i = 0; i < 3; ++i) whole_[t_.face(f).vertex[i]] += std::atan2(t_.face(f).sine[i], t_.face(f).cosine[i]);
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

  /// The sine of the smallest angle; 1 if the face is good, or no vertex can make it better.
  Bad judge(Index f) const {
    const auto& face = t_.face(f);
    const int i = static_cast<int>(std::min_element(face.length, face.length + 3) - face.length), apex = (i + 2) % 3;
    const double sine = face.cosine[apex] > 0 ? face.sine[apex] : 1;
    if (sine >= least_sine_) return {1, f};
    const Index v = face.vertex[apex], h = 3 * f + static_cast<Index>(apex);
    const bool sharp = v < whole_.size() && whole_[v] < std::numbers::pi / 3;
    const bool caught = t_.flat_twin(h) == no_index && t_.flat_twin(SurfaceMesh::previous(h)) == no_index;
    return {sharp || caught ? 1 : sine, f};
  }

  void consider(Index f) {
    const Bad bad = judge(f);
    if (bad.sine < 1) bad_.push(bad);
  }

  /// Puts a vertex at the centre of the circle around a face, or on the edge in its way.
  void improve(Index f) {
    const auto& face = t_.face(f);
    Index h = 3 * f + static_cast<Index>(std::max_element(face.length, face.length + 3) - face.length);
    const Point2 top = t_.apex(h);
    const double half = t_.length(h) / 2;
    if (top.y <= flat_share * half) return split(h, top.x);
    Point2 p{half, (dot(top, top) - 2 * half * top.x) / (2 * top.y)};
    for (int step = 0; step < 1000; ++step) {
      const Index way_out = edge_before(h, p);
      if (way_out == no_index) return insert(h, p);
      const Index g = t_.flat_twin(way_out);
      if (g == no_index) return split(way_out, t_.length(way_out) / 2);
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
      if (t_.flat_twin(h) == no_index && q.x * (q.x - whole) + q.y * q.y < 0) return split(h, whole / 2);
      q = t_.in_next_frame(h, q), h = SurfaceMesh::next(h);
    }
    const Index first = t_.face_count(), f = h / 3;
    t_.split_face(h, p);
    changed_.assign(1, f);
    settle(first);
  }

  void split(Index h, double x) {
    const Index first = t_.face_count();
    changed_.assign(1, h / 3);
    for (Index g = t_.next_on_edge(h); g != h; g = t_.next_on_edge(g)) changed_.push_back(g / 3);
    if (t_.split_edge(h, x) != no_index) settle(first);
  }

  /// Restores the Delaunay property around faces that changed and new ones, and looks at all that became of them.
  void settle(Index first_new_face) {
    for (Index f = first_new_face; f < t_.face_count(); ++f) changed_.push_back(f);
    for (const Index f : changed_)
      for (Index i = 0; i < 3; ++i) stack_.push_back(3 * f + i);
    flip_until_delaunay(t_, stack_, changed_, context_);
    for (const Index f : changed_) consider(f);
  }

  static constexpr double flat_share = 1e-6;

  IntrinsicTriangulation& t_;
  const RunContext& context_;
  double least_sine_;
  Index most_;
  std::vector<double> whole_;  ///< total angle of the vertices of the mesh
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
