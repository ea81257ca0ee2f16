// SPDX-License-Identifier: MIT
#include "tools/shapes/hostile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "tools/shapes/grid_mesh.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/refine.hpp"

namespace geodrome::shapes {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Triangles around `apex` over a ring of `count` vertices from `first` on, seen counterclockwise from outside unless
/// `inverted`.
void add_fan(std::vector<Triangle>& triangles, Index apex, Index first, Index count, bool inverted) {
  for (Index i = 0; i < count; ++i) {
    const Index a = first + i, b = first + (i + 1) % count;
    triangles.push_back(inverted ? Triangle{apex, b, a} : Triangle{apex, a, b});
  }
}

Index of(std::size_t size, Index small, Index middle, Index large) { return std::array{small, middle, large}[size]; }

/// The rectangles of one side of a box, welded to what is there already by place.
class BoxBuilder {
 public:
  explicit BoxBuilder(std::array<Index, 3> size) : size_(size) {}

  /// The side across `axis` at its low or high end.
  void add_side(int axis, bool high) {
    const int across = (axis + 1) % 3, up = (axis + 2) % 3;
    const auto at = [&](Index u, Index v) {
      std::array<Index, 3> place{};
      place[axis] = high ? size_[axis] : 0, place[across] = u, place[up] = v;
      return vertex(place);
    };
    for (Index v = 0; v < size_[up]; ++v)
      for (Index u = 0; u < size_[across]; ++u)
        add_quad({at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1)}, high, (u + v) % 2 == 1);
  }

  SurfaceMesh finish() { return SurfaceMesh(std::move(positions_), std::move(triangles_)); }

 private:
  Index vertex(const std::array<Index, 3>& place) {
    const auto [entry, is_new] = vertices_.emplace(place, static_cast<Index>(positions_.size()));
    if (is_new)
      positions_.push_back(
          {static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])});
    return entry->second;
  }

  void add_quad(std::array<Index, 4> quad, bool outwards, bool other_diagonal) {
    if (!outwards) std::swap(quad[1], quad[3]);
    const auto& [a, b, c, d] = quad;
    if (other_diagonal)
      triangles_.push_back({a, b, d}), triangles_.push_back({b, c, d});
    else
      triangles_.push_back({a, b, c}), triangles_.push_back({a, c, d});
  }

  std::array<Index, 3> size_;
  std::map<std::array<Index, 3>, Index> vertices_;
  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;
};

}  // namespace

SurfaceMesh terrain(Index n, double height, std::uint64_t seed) {
  Random random(seed);
  return grid_mesh(n - 1, n - 1, Diagonals::parallel, [&](Index i, Index j) {
    return Vec3{static_cast<double>(i), static_cast<double>(j), random.uniform(-height, height)};
  });
}

SurfaceMesh needle_cone(Index degree, Index lobes) {
  constexpr Index rings = 10;
  constexpr double ratio = 1.3, slope = 0.5;
  std::vector<Vec3> positions{{0, 0, 0}};
  double radius = 1;
  for (Index ring = 0; ring < rings; ++ring, radius *= ratio)
    for (Index i = 0; i < degree; ++i) {
      const double azimuth = full_turn * i / degree;
      positions.push_back(
          {radius * std::cos(azimuth), radius * std::sin(azimuth), slope * radius * std::cos(lobes * azimuth)});
    }
  // Rows run outwards, so that the side seen from above is the one of the fan.
  std::vector<Triangle> triangles = grid_triangles(degree, rings - 1, true, Diagonals::parallel, 1);
  for (auto& [a, b, c] : triangles) std::swap(b, c);
  add_fan(triangles, 0, 1, degree, false);
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

SurfaceMesh needle_cylinder(Index around, Index along) {
  constexpr double length = 20;
  std::vector<Vec3> positions;
  for (Index j = 0; j <= along; ++j)
    for (Index i = 0; i < around; ++i) {
      const double azimuth = full_turn * i / around;
      positions.push_back({std::cos(azimuth), std::sin(azimuth), length * j / along});
    }
  std::vector<Triangle> triangles = grid_triangles(around, along, true, Diagonals::parallel);
  const auto bottom = static_cast<Index>(positions.size());
  positions.push_back({0, 0, 0});
  positions.push_back({0, 0, length});
  add_fan(triangles, bottom, 0, around, true);
  add_fan(triangles, bottom + 1, along * around, around, false);
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

SurfaceMesh stretched_waves(Index n, double aspect, std::uint64_t seed) {
  constexpr double amplitude = 0.5, noise = 0.2;
  Random random(seed);
  return grid_mesh(n, n, Diagonals::parallel, [&](Index i, Index j) {
    const double waves = std::sin(0.7 * i) + std::sin(0.4 * j + 0.2 * i);
    return Vec3{aspect * i, static_cast<double>(j), amplitude * waves + random.uniform(-noise, noise)};
  });
}

SurfaceMesh graded_grid(Index n, std::uint64_t seed) {
  constexpr double growth = 1.25, roughness = 0.25;
  Random random(seed);
  return grid_mesh(n, n, Diagonals::parallel, [&](Index i, Index j) {
    // Rows of height 0.25 * 1.25^k add up to 1.25^j - 1.
    const double row = 0.25 * std::pow(growth, j), reach = roughness * std::min(1.0, row);
    return Vec3{static_cast<double>(i), std::pow(growth, j) - 1, random.uniform(-reach, reach)};
  });
}

SurfaceMesh spiral_corridor(Index turns) {
  constexpr Index pieces = 48, lanes = 4;
  constexpr double pitch = 1.25, width = 1;
  return grid_mesh(lanes, turns * pieces, Diagonals::parallel, [&](Index lane, Index piece) {
    const double azimuth = full_turn * piece / pieces;
    const double radius = 1 + pitch * piece / pieces + width * lane / lanes;
    return Vec3{radius * std::cos(azimuth), radius * std::sin(azimuth), 0};
  });
}

SurfaceMesh spiral_stair(Index turns) {
  constexpr Index steps = 16, lanes = 4;
  constexpr double inner = 1, outer = 3, rise = 0.3;
  return grid_mesh(lanes, 2 * turns * steps, Diagonals::parallel, [&](Index lane, Index edge) {
    const double azimuth = full_turn * ((edge + 1) / 2) / steps, radius = inner + (outer - inner) * lane / lanes;
    return Vec3{radius * std::cos(azimuth), radius * std::sin(azimuth), rise * (edge / 2)};
  });
}

SurfaceMesh near_flat(Index n, double jitter, std::uint64_t seed) {
  Random random(seed);
  return grid_mesh(n, n, Diagonals::chess_board, [&](Index i, Index j) {
    const double x = i + random.uniform(-jitter, jitter), y = j + random.uniform(-jitter, jitter);
    const double height = std::pow(10, -random.uniform(5, 7));
    return Vec3{x, y, random.uniform() < 0.5 ? height : -height};
  });
}

SurfaceMesh collapsed_faces(Index n, std::uint64_t seed) {
  const SurfaceMesh whole = terrain(n, 0.5, seed);
  std::vector<Vec3> positions(whole.positions().begin(), whole.positions().end());
  Random random(seed);
  for (Index j = 1; j + 1 < n; j += 3)  // three apart, so that no neighbour of one moves
    for (Index i = 1; i + 1 < n; i += 3) {
      const Index v = j * n + i;
      const Index ring[] = {v + 1, v + n + 1, v + n, v - 1, v - n - 1, v - n};
      const std::size_t side = random.index(6);
      positions[v] = 0.5 * (positions[ring[side]] + positions[ring[(side + 1) % 6]]);
    }
  return SurfaceMesh(std::move(positions), {whole.triangles().begin(), whole.triangles().end()});
}

SurfaceMesh lattice_box(Index nx, Index ny, Index nz) {
  BoxBuilder box({nx, ny, nz});
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) box.add_side(axis, high);
  return box.finish();
}

SurfaceMesh octahedron(Index levels) {
  const SurfaceMesh coarse({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                           {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  return refine_by_midpoints(coarse, std::size_t{8} << (2 * levels));
}

SurfaceMesh pillow(Index n) {
  const SurfaceMesh top = grid_mesh(n, n, Diagonals::chess_board, [](Index i, Index j) {
    return Vec3{static_cast<double>(i), static_cast<double>(j), 0};
  });
  std::vector<Vec3> positions(top.positions().begin(), top.positions().end());
  std::vector<Triangle> triangles(top.triangles().begin(), top.triangles().end());
  std::vector<Index> below(positions.size());
  for (Index v = 0; v < below.size(); ++v) {
    const Index i = v % (n + 1), j = v / (n + 1);
    const bool on_border = i == 0 || j == 0 || i == n || j == n;
    below[v] = on_border ? v : static_cast<Index>(positions.size());
    if (!on_border) positions.push_back(positions[v]);
  }
  for (const auto& [a, b, c] : top.triangles()) triangles.push_back({below[a], below[c], below[b]});
  return SurfaceMesh(std::move(positions), std::move(triangles));
}

const std::vector<HostileFamily>& hostile_families() {
  using Size = std::size_t;
  using Seed = std::uint64_t;
  static const std::vector<HostileFamily> families{
      {"terrain-5", [](Size s, Seed seed) { return terrain(of(s, 21, 41, 81), 5, seed); }},
      {"terrain-50", [](Size s, Seed seed) { return terrain(of(s, 21, 41, 81), 50, seed); }},
      {"needle-cone", [](Size s, Seed) { return needle_cone(of(s, 400, 1600, 6400), 0); }},
      {"needle-saddle", [](Size s, Seed) { return needle_cone(of(s, 400, 1600, 6400), 3); }},
      {"needle-cylinder", [](Size s, Seed) { return needle_cylinder(of(s, 64, 256, 1024), of(s, 1, 2, 4)); }},
      {"stretched-30", [](Size s, Seed seed) { return stretched_waves(of(s, 24, 48, 96), 30, seed); }},
      {"stretched-1000", [](Size s, Seed seed) { return stretched_waves(of(s, 24, 48, 96), 1000, seed); }},
      {"graded-grid", [](Size s, Seed seed) { return graded_grid(of(s, 16, 32, 64), seed); }},
      {"spiral-corridor", [](Size s, Seed) { return spiral_corridor(of(s, 4, 8, 16)); }},
      {"spiral-stair", [](Size s, Seed) { return spiral_stair(of(s, 6, 12, 24)); }},
      {"near-flat", [](Size s, Seed seed) { return near_flat(of(s, 24, 48, 96), 0, seed); }},
      {"near-flat-jittered", [](Size s, Seed seed) { return near_flat(of(s, 24, 48, 96), 0.2, seed); }},
      {"collapsed-faces", [](Size s, Seed seed) { return collapsed_faces(of(s, 13, 25, 49), seed); }},
      {"cube", [](Size s, Seed) { return lattice_box(of(s, 8, 16, 32), of(s, 8, 16, 32), of(s, 8, 16, 32)); }},
      {"flat-box", [](Size s, Seed) { return lattice_box(of(s, 16, 32, 64), of(s, 16, 32, 64), 1); }},
      {"octahedron", [](Size s, Seed) { return octahedron(of(s, 3, 4, 5)); }},
      {"pillow", [](Size s, Seed) { return pillow(of(s, 16, 32, 64)); }},
  };
  return families;
}

SurfaceMesh hostile(const std::string& name, std::size_t size, std::uint64_t seed) {
  std::string valid;
  for (const HostileFamily& family : hostile_families()) {
    if (family.name == name && size <= 2) return family.make(size, seed);
    valid += (valid.empty() ? "" : ", ") + family.name;
  }
  throw OptionError("no hostile mesh '" + name + "' of size " + std::to_string(size),
                    "sizes are 0, 1 and 2; valid names: " + valid);
}

}  // namespace geodrome::shapes
