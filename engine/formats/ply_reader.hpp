// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "engine/formats/soup.hpp"

namespace geodrome::input {

/// A PLY file and, unless the name is empty, the numbers of one property of its faces, which must be there if it has
/// faces. Throws InputError, naming the line or element, for what is no PLY.
Soup read_ply(const SourceFile& file, std::string_view weight_property);

}  // namespace geodrome::input
