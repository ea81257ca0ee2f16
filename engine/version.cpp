// SPDX-License-Identifier: MIT
#include "geodrome/engine/version.hpp"

namespace geodrome {

const char* version() noexcept { return GEODROME_VERSION; }

}  // namespace geodrome
