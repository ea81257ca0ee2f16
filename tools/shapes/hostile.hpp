// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geodrome/surface.hpp"

/// Meshes built to break exact geodesic solvers. All are oriented manifolds in one component; lengths are in units of
/// the spacing of their grid unless said otherwise. Same arguments, same bytes.
namespace geodrome::shapes {

/// Random terrain: n x n vertices on the integer grid of the plane, heights uniform in [-height, height]. Open. From
/// height 5 on nearly every inner vertex is a saddle or a peak, and faces are needles that stand on end.
SurfaceMesh terrain(Index n, double height, std::uint64_t seed);

/// A fan of `degree` needles around vertex 0, the apex at the origin, and around it ten rings whose radii grow from 1
/// by the ratio 1.3. Vertex i of ring k is 1 + k degree + i, at azimuth 2 pi i / degree and height 0.5 r cos(lobes
/// azimuth). Open. 0 lobes: a cone, all of whose vertices are convex; 2 or more: the apex is a saddle.
SurfaceMesh needle_cone(Index degree, Index lobes);

/// A cylinder of radius 1 from z = 0 to 20: `around` x `along` rectangles, each cut in two, and a fan on either end.
/// Closed; the angle at the two vertices in the middle of the ends is 2 pi up to rounding.
SurfaceMesh needle_cylinder(Index around, Index along);

/// n x n quads over a grid whose columns are `aspect` wide and whose rows are 1 high. The height of vertex (i, j) is
/// 0.5 (sin 0.7 i + sin(0.4 j + 0.2 i)) plus noise, uniform in +-0.2. Open; a quad's sides have a ratio of about
/// `aspect`.
SurfaceMesh stretched_waves(Index n, double aspect, std::uint64_t seed);

/// n columns 1 wide and n rows, the first 1/4 high, each 1.25 times as high as the one before it. Heights are uniform
/// in +-0.25 of the smaller side of the cell. Open: needles one way at one end, the other way at the other end.
SurfaceMesh graded_grid(Index n, std::uint64_t seed);

/// A flat corridor of width 1 that winds outwards `turns` times with a pitch of 1.25, cut into 48 pieces a turn and
/// four lanes. Open, a disc; the ways along it bend at every vertex of the inner wall they touch.
SurfaceMesh spiral_corridor(Index turns);

/// A spiral staircase around the z axis, from radius 1 to 3: 16 steps a turn, each a tread and a riser 0.3 high, four
/// lanes. Open, a disc; treads and risers meet at a total angle above pi along the inner wall.
SurfaceMesh spiral_stair(Index turns);

/// n x n quads of a plane grid; every vertex is moved in the plane by up to `jitter` in each coordinate, and out of it
/// by 10^-u, u uniform in [5, 7], up or down. Open. The angle at inner vertices differs from 2 pi by 1e-14 to 1e-10,
/// above or below.
SurfaceMesh near_flat(Index n, double jitter, std::uint64_t seed);

/// Terrain of n x n vertices and height 0.5 in which every ninth vertex lies in the middle of an edge opposite to it:
/// the face between has no area up to rounding, and distances go along it like along two edges in one. Open.
SurfaceMesh collapsed_faces(Index n, std::uint64_t seed);

/// The box of nx x ny x nz unit cubes; diagonals alternate like the fields of a chess board. Closed; many ways tie
/// exactly.
SurfaceMesh lattice_box(Index nx, Index ny, Index nz);

/// The octahedron of radius 1, each face cut into four `levels` times by the middles of edges. Closed, 8 x 4^levels
/// faces, all angles 60 degrees up to rounding.
SurfaceMesh octahedron(Index levels);

/// Two sheets of n x n quads of the plane grid that share their border: a closed surface without volume, for an even n.
/// Vertices inside are flat, and each has a twin at the same place on the other sheet.
SurfaceMesh pillow(Index n);

/// A family with three sizes: 0 is below 2,000 faces, or up to 8,000 where needles are the point; 2 is the size that
/// solvers are measured on (terrain of 81 x 81 vertices, a fan of 6,400 needles).
struct HostileFamily {
  std::string name;
  SurfaceMesh (*make)(std::size_t size, std::uint64_t seed);
};
const std::vector<HostileFamily>& hostile_families();

/// Throws OptionError for an unknown name or a size above 2.
SurfaceMesh hostile(const std::string& name, std::size_t size, std::uint64_t seed = 1);

}  // namespace geodrome::shapes
