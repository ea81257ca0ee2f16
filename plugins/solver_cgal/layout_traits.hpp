// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "geodrome/run_context.hpp"

namespace geodrome::cgal {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// CGAL's search has no way to be stopped. It lays out a triangle for every window, so the layout asks.
class CancelPoll {
 public:
  void watch(const RunContext* context) { context_ = context; }
  void operator()() {
    if (context_ && ++count_ % interval == 0) context_->throw_if_cancelled();
  }

 private:
  static constexpr std::uint32_t interval = 4096;
  const RunContext* context_ = nullptr;
  std::uint32_t count_ = 0;
};

/// A triangle seen from its first edge: the third corner's place along it and height above it. Only differences of
/// coordinates enter, and a face of no height or with a base of no length is as good as any other (CGAL's own layout
/// projects on a line and divides by its length).
struct Shape {
  double base, along, height;

  explicit Shape(const Kernel::Triangle_3& t) {
    const Kernel::Vector_3 edge = t[1] - t[0], side = t[2] - t[0];
    base = std::sqrt(edge.squared_length());
    along = base > 0 ? edge * side / base : 0;
    height = std::sqrt(base > 0 ? CGAL::cross_product(edge, side).squared_length() / edge.squared_length()
                                : side.squared_length());
  }
};

struct LayOut {
  Kernel::Triangle_2 operator()(const Kernel::Triangle_3& t) const {
    const Shape shape(t);
    return {{0, 0}, {shape.base, 0}, {shape.along, shape.height}};
  }
};

struct LayOutAlongSegment {
  CancelPoll* poll = nullptr;

  /// CGAL calls this with edge 0 only: the triangle's first edge comes to lie on `segment`.
  Kernel::Triangle_2 operator()(const Kernel::Triangle_3& t, int /*edge*/, const Kernel::Segment_2& segment) const {
    if (poll) (*poll)();
    const Shape shape(t);
    const Kernel::Vector_2 edge = segment.to_vector();
    const double length = std::sqrt(edge.squared_length());
    const Kernel::Vector_2 x = length > 0 ? edge / length : Kernel::Vector_2(1, 0);
    const Kernel::Vector_2 y(-x.y(), x.x());
    return {segment.source(), segment.target(), segment.source() + shape.along * x + shape.height * y};
  }
};

/// Total angle at least 2 pi, flat vertices included: a straight line that runs through a flat vertex can be lost to
/// rounding between the windows on its two sides; one window more from the vertex itself closes that gap. Angles are
/// taken by atan2, which is exact to rounding for needles too, where the arc cosine errs by 1e-8.
struct IsSaddle {
  bool operator()(Mesh::Vertex_index v, const Mesh& mesh,
                  const Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>& points) const {
    double sum = 0;
    std::size_t corners = 0;
    for (const Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh)) {
      if (mesh.is_border(h)) continue;
      const Kernel::Vector_3 p = points[mesh.source(h)] - points[v];
      const Kernel::Vector_3 q = points[mesh.target(mesh.next(h))] - points[v];
      sum += std::atan2(std::sqrt(CGAL::cross_product(p, q).squared_length()), p * q);
      ++corners;
    }
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * static_cast<double>(corners);
    return sum >= 2 * std::numbers::pi - rounding;
  }
};

/// The traits of the search, with the three functions above in place of CGAL's.
class LayoutTraits : public CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh> {
 public:
  using Construct_triangle_3_to_triangle_2_projection = LayOut;
  using Construct_triangle_3_along_segment_2_flattening = LayOutAlongSegment;
  using Is_saddle_vertex = IsSaddle;

  explicit LayoutTraits(CancelPoll* poll = nullptr)
      : CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>(Kernel()), poll_(poll) {}

  LayOut construct_triangle_3_to_triangle_2_projection_object() const { return {}; }
  LayOutAlongSegment construct_triangle_3_along_segment_2_flattening_object() const { return {poll_}; }
  IsSaddle is_saddle_vertex_object() const { return {}; }

 private:
  CancelPoll* poll_;
};

}  // namespace geodrome::cgal
