// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/checks/claims.hpp"

namespace geodrome {

/// One thing that is wrong, or nearly so, at a place.
struct Trouble {
  std::string code;   ///< of the claim or of the finding
  std::string what;   ///< for people
  bool fails = true;  ///< false: the bound is strained, and holds
  bool has_bound = false;
  double measured = 0;  ///< if has_bound
  double bound = 0;
  std::string source, remedy;
};

/// A neighbourhood of a few psi: the point that stands for it, and what is wrong there, the gravest first.
struct WorstPlace {
  Index row = no_index;  ///< of the input
  Vec3 position;
  std::vector<Trouble> troubles;
};

inline constexpr std::size_t worst_places_shown = 10;

/// The worst places of a sample, at most `worst_places_shown`, none within a few psi of another.
///
/// First come, in turns, what refusals and warnings name and the claims that fail, each from its worst on, so that one
/// kind of trouble cannot hide the others; then the places where a bound is strained most. Everything that fails near a
/// place is told there. `findings`: their elements are rows of the input. O(n) beyond the claims' own order.
std::vector<WorstPlace> worst_places(const Input& input, const PlacedSurface& surface, std::span<const Claim> claims,
                                     std::span<const Finding> findings);

}  // namespace geodrome
