// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "geodrome/surface.hpp"

/// Small meshes of known facts. All are oriented manifolds unless their comment says otherwise.
namespace geodrome::shapes::small {

/// A number in [0, 1), the same on every platform.
inline double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

inline MeshPtr make(std::vector<Vec3> positions, std::vector<Triangle> triangles) {
  return std::make_shared<const SurfaceMesh>(std::move(positions), std::move(triangles));
}

/// Every position through `map`; the same faces.
template <class Map>
MeshPtr mapped(const MeshPtr& mesh, Map&& map) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh->positions()) positions.push_back(map(p));
  return make(std::move(positions), {mesh->triangles().begin(), mesh->triangles().end()});
}

/// n x n squares of side 1, vertex (i, j) = i (n + 1) + j at (i, j, 0); diagonals alternate if `crossed`.
inline MeshPtr plane_grid(Index n, bool crossed = false) {
  std::vector<Vec3> p;
  std::vector<Triangle> t;
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= n; ++j) p.push_back({static_cast<double>(i), static_cast<double>(j), 0});
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Index a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      if (crossed && (i + j) % 2)
        t.push_back({a, b, d}), t.push_back({b, c, d});
      else
        t.push_back({a, b, c}), t.push_back({a, c, d});
    }
  return make(p, t);
}

/// The cube [0, 1]^3: 8 vertices, number x + 2 y + 4 z.
inline MeshPtr cube() {
  std::vector<Vec3> p;
  for (int v = 0; v < 8; ++v) p.push_back({double(v & 1), double(v >> 1 & 1), double(v >> 2)});
  return make(p, {{0, 2, 1},
                  {1, 2, 3},
                  {4, 5, 6},
                  {5, 7, 6},
                  {0, 1, 4},
                  {1, 5, 4},
                  {2, 6, 3},
                  {3, 6, 7},
                  {0, 4, 2},
                  {2, 4, 6},
                  {1, 3, 5},
                  {3, 7, 5}});
}

/// The octahedron of radius 1: vertices +x -x +y -y +z -z.
inline MeshPtr octahedron() {
  return make({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
              {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

/// A grid of m x n quads, closed in the first direction if `wrap_first`, in the second if `wrap_second`; vertex (i, j)
/// at `place(i, j)` is number i * columns + j.
template <class Place>
MeshPtr tube(Index m, Index n, bool wrap_first, bool wrap_second, Place&& place) {
  const Index rows = wrap_first ? m : m + 1, columns = wrap_second ? n : n + 1;
  std::vector<Vec3> p;
  std::vector<Triangle> t;
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) p.push_back(place(i, j));
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < n; ++j) {
      const auto at = [&](Index a, Index b) { return a % rows * columns + b % columns; };
      t.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      t.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return make(p, t);
}

/// The side of a prism over a regular m-gon of radius 1, n layers of `height`; vertex (i, j): corner i, layer j.
inline MeshPtr prism(Index m, Index n, double height) {
  return tube(m, n, true, false, [=](Index i, Index j) {
    const double angle = 2 * std::numbers::pi * i / m;
    return Vec3{std::cos(angle), std::sin(angle), j * height};
  });
}

/// A torus of radii 1 and 0.4, moved radially by up to `noise` with a seed: saddles, and no symmetry.
inline MeshPtr bumpy_torus(Index m, Index n, double noise, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return tube(m, n, true, true, [&](Index i, Index j) {
    const double u = 2 * std::numbers::pi * i / m, v = 2 * std::numbers::pi * j / n;
    const double small = 0.4 + noise * (2 * uniform(random) - 1), r = 1 + small * std::cos(v);
    return Vec3{r * std::cos(u), r * std::sin(u), small * std::sin(v)};
  });
}

/// A fan of `m` triangles around vertex 0 at the origin: a pyramid's side without base. The apex angle of each triangle
/// is `angle`; with m * angle > 2 pi the apex is a saddle (its rim goes up and down). Rim vertices are 1 ... m at
/// distance 1.
inline MeshPtr fan(Index m, double angle) {
  // Rim vertex i at azimuth 2 pi i / m and elevation +-e alternately (saddle) or e for all (cone): solve for e by
  // bisection.
  const bool saddle = m * angle > 2 * std::numbers::pi;
  const auto rim = [&](Index i, double e) {
    const double a = 2 * std::numbers::pi * i / m, s = saddle && i % 2 ? -e : e;
    return Vec3{std::cos(s) * std::cos(a), std::cos(s) * std::sin(a), std::sin(s)};
  };
  double low = 0, high = std::numbers::pi / 2;
  for (int k = 0; k < 200; ++k) {
    const double middle = (low + high) / 2;
    const double apart = std::acos(dot(rim(0, middle), rim(1, middle)));
    (apart > angle) == saddle ? high = middle : low = middle;
  }
  std::vector<Vec3> p{{0, 0, 0}};
  std::vector<Triangle> t;
  for (Index i = 0; i < m; ++i) p.push_back(rim(i, low)), t.push_back({0, 1 + i, 1 + (i + 1) % m});
  return make(p, t);
}

/// Terrain over n x n squares of side 1 with heights uniform in [-height, height].
inline MeshPtr terrain(Index n, double height, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return mapped(plane_grid(n), [&](Vec3 p) { return p.z = height * (2 * uniform(random) - 1), p; });
}

/// Both meshes side by side, not connected; the second one's vertices and faces follow.
inline MeshPtr both(const MeshPtr& a, const MeshPtr& b) {
  std::vector<Vec3> p(a->positions().begin(), a->positions().end());
  p.insert(p.end(), b->positions().begin(), b->positions().end());
  std::vector<Triangle> t(a->triangles().begin(), a->triangles().end());
  const auto shift = static_cast<Index>(a->vertex_count());
  for (const Triangle& f : b->triangles()) t.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return make(p, t);
}

/// Two triangles that share vertex 0 alone: not manifold. Vertices 1, 2 and 3, 4 are sqrt(2) from it.
inline MeshPtr bow_tie() {
  return make({{0, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 3, 4}});
}

/// Two triangles on the edge from (0, 0, 0) to (2, 0, 0), one of them cut into `count` + 1 by as many vertices on that
/// edge; faces without area, which follow one another in any way, between both sides.
inline MeshPtr seam(Index count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> at{0, 2};
  for (Index i = 0; i < count; ++i) at.push_back(0.05 + 1.9 * uniform(random));
  std::sort(at.begin(), at.end());
  std::vector<Vec3> p;
  for (const double x : at) p.push_back({x, 0, 0});
  const Index last = count + 1, above = count + 2, below = count + 3;
  p.push_back({1, 1, 0}), p.push_back({1, -1, 0});
  std::vector<Triangle> t{{last, 0, below}};
  for (Index i = 0; i < last; ++i) t.push_back({i, i + 1, above});
  for (std::vector<std::pair<Index, Index>> spans{{0, last}}; !spans.empty();) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    if (to - from < 2) continue;
    const Index middle = from + 1 + static_cast<Index>(random() % (to - from - 1));
    t.push_back({from, to, middle});
    spans.emplace_back(from, middle), spans.emplace_back(middle, to);
  }
  return make(p, t);
}

/// Three triangles on the edge 0-1: not manifold.
inline MeshPtr book() {
  return make({{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-1, 1, 0.5}, {-1, -1, 0.5}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
}

/// A Moebius strip of n quads: manifold, not oriented. Vertices 2 i and 2 i + 1 lie on the two sides of quad i.
inline MeshPtr moebius(Index n) {
  std::vector<Vec3> p;
  std::vector<Triangle> t;
  for (Index i = 0; i < n; ++i)
    for (const double s : {-0.3, 0.3}) {
      const double u = 2 * std::numbers::pi * i / n;
      const double r = 1 + s * std::cos(u / 2);
      p.push_back({r * std::cos(u), r * std::sin(u), s * std::sin(u / 2)});
    }
  for (Index i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const Index a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    t.push_back({a, c, d}), t.push_back({a, d, b});
  }
  return make(p, t);
}

/// The mesh with a third face, of a new vertex, on the first edge of every `apart`-th of its faces: not manifold.
inline MeshPtr finned(const MeshPtr& mesh, std::size_t apart) {
  std::vector<Vec3> p(mesh->positions().begin(), mesh->positions().end());
  std::vector<Triangle> t(mesh->triangles().begin(), mesh->triangles().end());
  for (Index f = 0; f < mesh->face_count(); f += static_cast<Index>(apart)) {
    const auto [a, b, c] = mesh->corners(f);
    t.push_back({mesh->triangles()[f][0], mesh->triangles()[f][1], static_cast<Index>(p.size())});
    p.push_back(0.4 * a + 0.6 * b + 0.7 * cross(b - a, c - a) / norm(b - a));
  }
  return make(p, t);
}

/// Every position moved by up to `by` in each coordinate, with a seed.
inline MeshPtr shaken(const MeshPtr& mesh, double by, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return mapped(mesh, [&](const Vec3& p) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return p + by * Vec3{2 * x - 1, 2 * y - 1, 2 * z - 1};
  });
}

/// What a closed mesh encloses; positive if its faces look outwards.
inline double volume(const SurfaceMesh& mesh) {
  double six_volumes = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto [p, q, r] = mesh.corners(f);
    six_volumes += dot(p, cross(q, r));
  }
  return six_volumes / 6;
}

/// Some seeded point of the surface: inside a face, on an edge or at a vertex.
inline SurfacePoint random_point(const SurfaceMesh& mesh, std::mt19937_64& random) {
  SurfacePoint point{static_cast<Index>(random() % mesh.face_count()), {}};
  const auto kind = random() % 4, i = random() % 3;
  if (kind == 0) {
    point.b[i] = 1;
  } else {
    double a = uniform(random), b = kind == 1 ? 0 : uniform(random) * (1 - a);
    point.b[i] = a, point.b[(i + 1) % 3] = b, point.b[(i + 2) % 3] = 1 - a - b;
  }
  return point;
}

}  // namespace geodrome::shapes::small
