// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome::merged_windows {

/// What the options of the plugin say.
struct Settings {
  double delta = 1e-3;  ///< a distance is at most 1 + delta times too long
};

}  // namespace geodrome::merged_windows
