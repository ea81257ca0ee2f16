// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome::merged_windows {

/// The distance that is answered, of the interval [l, D] that is known.
enum class Value {
  upper,  ///< D, the length of a path
  middle  ///< (l + D) / 2, which may be too short
};

/// What the options of the plugin say.
struct Settings {
  double delta = 1e-3;  ///< D is at most 1 + delta times too long
  /// The run begins again with exact windows where more than so many are carried across a face, in the mean, or where
  /// more than so many merges are tried for one that is made. No options of the plugin: figures say what is fastest.
  double long_list = 8, many_tries = 8;
  /// Exact windows are used at once where F^1.5 delta is below this: the run would be over before much could merge.
  double few_faces = 20;
  Value value = Value::upper;
};

}  // namespace geodrome::merged_windows
