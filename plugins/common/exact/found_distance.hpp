// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/geometry.hpp"

namespace geodrome {

/// What a propagation answers for a vertex.
struct FoundDistance {
  double distance = infinity;
  Index source = no_index;  ///< of the request; none where nothing was found
};

}  // namespace geodrome
