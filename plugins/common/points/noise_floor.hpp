// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

/// psi is at least this many sigma of the noise that the tangents state: closer points differ by noise more than by
/// shape, and triangles of that size would follow it. Being the maximum of two Lipschitz functions, psi stays one.
inline constexpr double noise_factor = 5;

}  // namespace geodrome
