// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/common_gpl/planar_triangles.hpp"

namespace geodrome {

/// The faces of the advancing front that never takes a triangle that the rule does not allow.
std::vector<Triangle> front_triangles(const FaceRule& rule);

}  // namespace geodrome
