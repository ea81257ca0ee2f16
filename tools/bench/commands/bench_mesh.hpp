// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "geodrome/surface.hpp"

namespace geodrome::bench {

/// The mesh of a file, or of a generator: "shape:KIND:FACES[:SEED]", "hostile:NAME:SIZE[:SEED]" (hostile.hpp) or
/// "fuzz:SEED" (fuzz_mesh.hpp). Throws OptionError for a shape that is not written so, InputError for a file without
/// faces or one that cannot be read.
MeshPtr load_mesh(const std::string& name);

}  // namespace geodrome::bench
