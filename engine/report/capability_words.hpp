// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace geodrome {

/// The words for the bits of `needs` and of a solver's `provides`, in the order of the bits.
std::vector<std::string> needs_words(std::uint64_t needs);
std::vector<std::string> provides_words(std::uint64_t provides);

}  // namespace geodrome
