// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shapes/small_meshes.hpp"

namespace geodrome::test {
using namespace shapes::small;
}
