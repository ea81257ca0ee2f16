// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

/// The engine's version, "major.minor.patch".
const char* version() noexcept;

}  // namespace geodrome
