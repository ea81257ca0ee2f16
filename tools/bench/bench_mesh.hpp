// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "geodrome/surface.hpp"

namespace geodrome::bench {

/// The mesh of a file, or of "shape:KIND:FACES[:SEED]" from the shape generator. Throws OptionError for a shape that is
/// not written so, InputError for a file without faces or one that cannot be read.
MeshPtr load_mesh(const std::string& name);

}  // namespace geodrome::bench
