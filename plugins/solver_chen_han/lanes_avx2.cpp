// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/lanes_body.hpp"

namespace geodrome::chen_han {
extern const Lanes avx2_lanes;
const Lanes avx2_lanes = lanes_of<4>;
}  // namespace geodrome::chen_han
