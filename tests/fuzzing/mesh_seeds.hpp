// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geodrome::fuzzing {

/// Sound files of a format ("OFF", ...) or, for an empty name, of all, each behind a byte of choices: small meshes,
/// parts of random ones, and the odd things that the format allows.
std::vector<std::string> mesh_seeds(std::string_view format);

}  // namespace geodrome::fuzzing
