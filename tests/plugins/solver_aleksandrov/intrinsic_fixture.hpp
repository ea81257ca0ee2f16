// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "plugins/solver_aleksandrov/intrinsic/triangulation.hpp"
#include "tests/support/meshes.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::aleksandrov::test {

using shapes::Random;

/// The length of edges without one.
inline constexpr double tiny = 1e-14;

struct NamedMesh {
  std::string name;
  MeshPtr mesh;
};

/// Closed and open, a third face on some edges, one-sided. Faces have area.
inline std::vector<NamedMesh> fair_meshes(std::uint64_t seed) {
  using namespace geodrome::test;
  return {{"torus", bumpy_torus(7, 5, 0.1, seed)},
          {"terrain", terrain(5, 0.8, seed)},
          {"finned terrain", finned(terrain(4, 0.6, seed), 3)},
          {"Moebius strip", shaken(moebius(7), 0.1, seed)}};
}

/// The same, and faces without area: three points in line, and two at one place.
inline std::vector<NamedMesh> all_meshes(std::uint64_t seed) {
  using namespace geodrome::test;
  std::vector<NamedMesh> all = fair_meshes(seed);
  all.push_back({"collapsed faces", std::make_shared<const SurfaceMesh>(shapes::collapsed_faces(7, seed))});
  all.push_back({"one edge without length", mapped(terrain(4, 0.5, seed), [](const Vec3& p) {
                   return p.x == 2 && p.y == 2 ? Vec3{2, 3, 0} : p.x == 2 && p.y == 3 ? Vec3{2, 3, 0} : p;
                 })});
  return all;
}

inline double angle(const IntrinsicTriangulation& t, Index h) {
  return std::atan2(t.face(h / 3).sine[h % 3], t.face(h / 3).cosine[h % 3]);
}

/// The sum of the angles opposite to an edge with two half-edges.
inline double opposite_angles(const IntrinsicTriangulation& t, Index g, Index h) {
  return angle(t, SurfaceMesh::previous(g)) + angle(t, SurfaceMesh::previous(h));
}

/// A legal flip: the new edge is inside both faces, clear of rounding.
inline bool may_flip(const IntrinsicTriangulation& t, Index h) {
  const Index g = t.flat_twin(h);
  if (g == no_index) return false;
  const double at_start = angle(t, h) + angle(t, SurfaceMesh::next(g));
  const double at_end = angle(t, g) + angle(t, SurfaceMesh::next(h));
  return at_start < std::numbers::pi - 0.01 && at_end < std::numbers::pi - 0.01;
}

/// One random legal flip, split of a face, or split of an edge; flips most often.
inline void change(IntrinsicTriangulation& t, Random& random) {
  const Index h = static_cast<Index>(random.index(3 * t.face_count()));
  const double kind = random.uniform();
  if (kind < 0.8) {
    if (may_flip(t, h)) t.flip(h);
  } else if (kind < 0.9) {
    const double a = random.uniform(0.1, 0.45), b = random.uniform(0.1, 0.45);
    t.split_face(h, Point2{a * t.length(h), 0} + b * t.apex(h));
  } else {
    t.split_edge(h, random.uniform(0.2, 0.8) * t.length(h));
  }
}

inline void change_often(IntrinsicTriangulation& t, int times, Random& random) {
  for (int i = 0; i < times; ++i) change(t, random);
}

/// Per vertex of the beginning.
inline std::vector<double> total_angles(const IntrinsicTriangulation& t, std::size_t vertices) {
  std::vector<double> total(vertices, 0);
  for (Index h = 0; h < 3 * t.face_count(); ++h)
    if (t.from(h) < vertices) total[t.from(h)] += angle(t, h);
  return total;
}

inline double area(const IntrinsicTriangulation& t) {
  double twice = 0;
  for (Index f = 0; f < t.face_count(); ++f) twice += t.length(3 * f) * t.apex(3 * f).y;
  return twice / 2;
}

inline int edge_count(const IntrinsicTriangulation& t) {
  int edges = 0;
  for (Index h = 0; h < 3 * t.face_count(); ++h) {
    bool lowest = true;
    for (Index g = t.next_on_edge(h); g != h; g = t.next_on_edge(g)) lowest = lowest && h < g;
    edges += lowest;
  }
  return edges;
}

inline int euler_number(const IntrinsicTriangulation& t) {
  return static_cast<int>(t.vertex_count()) - edge_count(t) + static_cast<int>(t.face_count());
}

inline Barycentric random_coordinates(Random& random) {
  const double a = random.uniform(), b = random.uniform() * (1 - a);
  return {a, b, 1 - a - b};
}

}  // namespace geodrome::aleksandrov::test
