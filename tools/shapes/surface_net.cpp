// SPDX-License-Identifier: MIT
#include "tools/shapes/surface_net.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geodrome/errors.hpp"
#include "tools/shapes/voxels.hpp"

namespace geodrome::shapes {
namespace {

using Quad = std::array<Index, 4>;

struct Net {
  std::vector<Vec3> positions;
  std::vector<Quad> quads;
};

/// The cells whose corners are on both sides, with one vertex each: the mean of the places where edges cross.
struct Crossed {
  std::vector<Cell> cells;  // sorted
  std::vector<std::array<bool, 8>> inside;
  std::vector<Vec3> positions;

  Index find(const Cell& cell) const {
    return static_cast<Index>(std::lower_bound(cells.begin(), cells.end(), cell) - cells.begin());
  }
};

/// Corner i of a cell is `cell` plus bit k of i along axis k.
Cell corner_of(Cell cell, int i) {
  for (int axis = 0; axis < 3; ++axis) cell[axis] += i >> axis & 1;
  return cell;
}

Crossed crossed_cells(const Implicit& surface, const VoxelGrid& grid) {
  Crossed crossed;
  for (const Cell& cell : cells_near(surface, grid)) {
    std::array<Vec3, 8> corner;
    std::array<double, 8> value;
    std::array<bool, 8> inside;
    for (int i = 0; i < 8; ++i) {
      corner[i] = grid.corner(corner_of(cell, i));
      value[i] = surface.at(corner[i]).value;
      inside[i] = value[i] < 0;
    }
    Vec3 sum;
    int crossings = 0;
    for (int i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const int j = i | 1 << axis;
        if (j == i || inside[i] == inside[j]) continue;
        sum = sum + corner[i] + value[i] / (value[i] - value[j]) * (corner[j] - corner[i]);
        ++crossings;
      }
    if (crossings == 0) continue;
    crossed.cells.push_back(cell);
    crossed.inside.push_back(inside);
    crossed.positions.push_back(sum / crossings);
  }
  return crossed;
}

/// One quad around each grid edge that crosses the surface, between the four cells that share the edge.
Net make_net(const Implicit& surface, double spacing) {
  Crossed crossed = crossed_cells(surface, VoxelGrid(surface, spacing));
  Net net;
  for (std::size_t c = 0; c < crossed.cells.size(); ++c)
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = crossed.inside[c][0];
      if (inside == crossed.inside[c][1 << axis]) continue;
      const int second = (axis + 1) % 3, third = (axis + 2) % 3;
      Cell left = crossed.cells[c], below = left, both = left;
      --left[second], --below[third], --both[second], --both[third];
      Quad quad{crossed.find(both), crossed.find(below), static_cast<Index>(c), crossed.find(left)};
      if (!inside) std::swap(quad[1], quad[3]);
      net.quads.push_back(quad);
    }
  net.positions = std::move(crossed.positions);
  return net;
}

SurfaceMesh triangulate(const Implicit& surface, Net net) {
  for (Vec3& position : net.positions) position = project(surface, position);
  std::vector<Triangle> triangles;
  triangles.reserve(2 * net.quads.size());
  for (const auto& [a, b, c, d] : net.quads) split_quad(net.positions, a, b, c, d, triangles);
  return SurfaceMesh(std::move(net.positions), std::move(triangles));
}

/// True for a closed, oriented 2-manifold whose Euler number is 2 - 2 genus.
bool has_genus(const SurfaceMesh& mesh, int genus) {
  const auto euler_number = static_cast<long>(mesh.vertex_count()) - static_cast<long>(mesh.face_count()) / 2;
  return mesh.manifold() && mesh.oriented() && mesh.closed() && euler_number == 2 - 2 * genus;
}

}  // namespace

void split_quad(const std::vector<Vec3>& positions, Index a, Index b, Index c, Index d, std::vector<Triangle>& out) {
  constexpr double clearly = 1 - 1e-9;
  const double first = squared_distance(positions[a], positions[c]);
  const double second = squared_distance(positions[b], positions[d]);
  if (second < clearly * first) {
    out.push_back({a, b, d});
    out.push_back({b, c, d});
  } else {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
  }
}

SurfaceMesh surface_net(const Implicit& surface, std::size_t faces) {
  // The number of faces goes with the inverse square of the spacing; a first net tells the factor.
  const double most = 2.0 * static_cast<double>(make_net(surface, surface.coarsest).quads.size());
  double spacing = surface.coarsest * std::sqrt(std::min(1.0, most / static_cast<double>(faces)));
  // Where a saddle of the surface lies level with a grid plane, a cell may hold two sheets, which the net would join.
  // About every tenth spacing does that; the next smaller one is another draw.
  constexpr int most_draws = 100;
  constexpr double next_draw = 0.99;
  for (int draw = 0; draw < most_draws; ++draw, spacing *= next_draw) {
    SurfaceMesh mesh = triangulate(surface, make_net(surface, spacing));
    if (has_genus(mesh, surface.genus)) return mesh;
  }
  throw NumericalError(std::string(surface.kind) + ": no grid gives a manifold of genus " +
                       std::to_string(surface.genus));
}

}  // namespace geodrome::shapes
