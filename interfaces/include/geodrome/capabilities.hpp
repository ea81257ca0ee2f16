// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

namespace geodrome {

/// The abilities of a solver beyond distances from vertices to vertices: a set of bits, `Provides::paths |
/// Provides::any_point`. 64 bits wide on every side of the border; a bit never changes its meaning.
enum class Provides : std::uint64_t {
  nothing = 0,
  start_distances = 1,     ///< sources with a start distance above 0
  face_sources = 2,        ///< sources that are no vertices
  radius_limit = 4,        ///< Request::radius
  target_limit = 8,        ///< Request::stop_at_targets
  any_point = 16,          ///< ShortestPathMap::at anywhere
  paths = 32,              ///< ShortestPathMap::path
  path_is_distance = 64,   ///< the path's length is the distance
  pair_queries = 128,      ///< PreparedSurface::pair_oracle, for any two points
  weights = 256,           ///< SurfaceMesh::face_weights
  factor_any_point = 512,  ///< the factor holds at any point, not only at vertices
  never_shorter = 1024,    ///< no distance is below the true one; a finite factor implies it, stated or not
};

/// The properties that a plugin needs of a mesh, as a set of bits. The engine refuses other meshes before it asks the
/// plugin.
enum class Needs : std::uint64_t {
  nothing = 0,
  manifold = 1,  ///< SurfaceMesh::manifold
  oriented = 2,  ///< SurfaceMesh::oriented
  closed = 4,    ///< SurfaceMesh::closed
};

/// A set of bits of one of the two kinds; they do not mix.
template <class Set>
concept Capabilities = std::same_as<Set, Provides> || std::same_as<Set, Needs>;

/// Union, intersection, complement. O(1), as all functions on sets.
template <Capabilities Set>
constexpr Set operator|(Set a, Set b) {
  return Set{static_cast<std::uint64_t>(a) | static_cast<std::uint64_t>(b)};
}
template <Capabilities Set>
constexpr Set operator&(Set a, Set b) {
  return Set{static_cast<std::uint64_t>(a) & static_cast<std::uint64_t>(b)};
}
template <Capabilities Set>
constexpr Set operator~(Set a) {
  return Set{~static_cast<std::uint64_t>(a)};
}
template <Capabilities Set>
constexpr Set& operator|=(Set& a, Set b) {
  return a = a | b;
}

/// Tells whether `set` holds every bit of `bits`.
template <Capabilities Set>
constexpr bool has(Set set, Set bits) {
  return (set & bits) == bits;
}

/// A bit and its name in reports and messages.
template <Capabilities Set>
struct CapabilityWord {
  Set bit;
  const char* word;
};

/// The bits that this version knows, in their order. These are the only lists of them beside the enumerations.
inline constexpr CapabilityWord<Provides> provides_words[] = {
    {Provides::start_distances, "start_distances"},
    {Provides::face_sources, "face_sources"},
    {Provides::radius_limit, "radius_limit"},
    {Provides::target_limit, "target_limit"},
    {Provides::any_point, "any_point"},
    {Provides::paths, "paths"},
    {Provides::path_is_distance, "path_is_distance"},
    {Provides::pair_queries, "pair_queries"},
    {Provides::weights, "weights"},
    {Provides::factor_any_point, "factor_any_point"},
    {Provides::never_shorter, "never_shorter"},
};
inline constexpr CapabilityWord<Needs> needs_words[] = {
    {Needs::manifold, "manifold"}, {Needs::oriented, "oriented"}, {Needs::closed, "closed"}};

/// The list of the kind of `Set`.
template <Capabilities Set>
constexpr const auto& known_words() {
  if constexpr (std::same_as<Set, Provides>)
    return provides_words;
  else
    return needs_words;
}

/// The names of the bits of `set`, in the order of the bits. Bits without a name are left out.
template <Capabilities Set>
std::vector<std::string> words_of(Set set) {
  std::vector<std::string> words;
  for (const auto& [bit, word] : known_words<Set>())
    if (has(set, bit)) words.emplace_back(word);
  return words;
}

/// The bits of `set` that this version has no name for.
template <Capabilities Set>
constexpr Set unknown_bits(Set set) {
  for (const auto& known : known_words<Set>()) set = set & ~known.bit;
  return set;
}

}  // namespace geodrome
