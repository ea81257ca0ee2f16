// SPDX-License-Identifier: MIT
#include "solver_chen_han/lanes_body.hpp"

namespace geodrome::chen_han {
extern const Lanes avx512_lanes;
const Lanes avx512_lanes = lanes_of<8>;
}  // namespace geodrome::chen_han
