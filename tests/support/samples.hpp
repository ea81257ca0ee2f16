// SPDX-License-Identifier: MIT
#pragma once

#include "tools/shapes/small_samples.hpp"

namespace geodrome::test {
using namespace shapes::small;
}
