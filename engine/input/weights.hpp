// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/formats/soup.hpp"
#include "engine/input/origin.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome::input {

/// Where weights come from; both are empty if there are none.
struct WeightChoice {
  std::string property;        ///< of the faces of a PLY file
  std::filesystem::path file;  ///< one number per face of the input
};

/// Reads `ReadOptions::weights`. Throws OptionError for a property without a name.
WeightChoice weight_choice(const std::string& option);

/// Gives each triangle of `input` the weight of the face in the file that it is a part of, and keeps where the weights
/// came from. Every face of the file needs one, those that were dropped too. Throws InputError, naming file and line
/// or face, for a count that differs and for weights outside of [1e-100, 1e100]. O(F).
void use_weights(const Origin& origin, const std::string& option, Soup& soup, Input& input);

/// Throws InputError: the input holds points, which have no faces to weigh.
[[noreturn]] void reject_weights_of_points(const Origin& origin);

}  // namespace geodrome::input
