// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geodrome/geometry.hpp"
#include "geodrome/remedy.hpp"

namespace geodrome {

/// Something a stage or the input check noticed. Findings never change the data: what was changed is told by one.
struct Finding {
  /// A note is worth knowing, a warning puts the result in doubt, a refusal is why there is none.
  enum class Severity { note, warning, refusal };

  Severity severity = Severity::note;
  std::string code;             ///< stable, lower case, for programs: "duplicate_faces"
  std::string message;          ///< one sentence for people
  std::size_t count = 0;        ///< how many elements are concerned
  std::vector<Index> elements;  ///< the first few of them; what they count (points, faces) is in the message
  Remedy remedy;                ///< empty where there is none
};

}  // namespace geodrome
