// SPDX-License-Identifier: MIT
#pragma once

#include "engine/formats/soup.hpp"
#include "engine/input/origin.hpp"
#include "geodrome/engine/input.hpp"

namespace geodrome::input {

/// The one check of every input, from a file or from memory: what cannot be used is rejected, what can be gets a place
/// for each of its rows, and what is odd becomes a finding. `hash`: of what the soup was made from. Throws InputError
/// as `read_input`. O(n log n).
Input check_soup(const Origin& origin, const ReadOptions& options, Soup soup, std::string hash);

}  // namespace geodrome::input
