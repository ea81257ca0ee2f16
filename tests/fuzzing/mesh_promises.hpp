// SPDX-License-Identifier: MIT
#pragma once

#include "engine/formats/soup.hpp"
#include "geodrome/engine/input.hpp"

/// What readers of meshes and points promise of their results.
namespace geodrome::fuzzing {

/// Demands that corners and faces are in range, and that nothing is larger than a file of `bytes` bytes can tell.
void demand_sound(const input::Soup& soup, std::size_t bytes);

/// Demands all that an Input promises: finite positions, indices in range, a place for each row, facts that agree with
/// the mesh.
void demand_sound(const Input& input);

/// Tells whether positions (bit by bit; all NaN are one), faces and weights are the same.
bool same(const input::Soup& a, const input::Soup& b);

/// Demands that both have the same mesh or points, and facts that follow from these.
void demand_same_mesh(const Input& a, const Input& b);

/// The soup as PLY.
enum class PlyText { ascii, little_endian, big_endian };
std::string ply_of(const input::Soup& soup, PlyText encoding);

}  // namespace geodrome::fuzzing
