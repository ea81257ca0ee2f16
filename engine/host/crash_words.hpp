// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace geodrome {

/// Installs the handlers of `install_crash_handlers`, which then write what they would say to `words`, ended by a null
/// character, in place of standard error. For a child process whose parent reads the words: `words` lies in memory that
/// both share, and lives as long as the process. `size` > 0: of `words`.
void tell_crashes_to(char* words, std::size_t size) noexcept;

}  // namespace geodrome
