// SPDX-License-Identifier: MIT
#pragma once

namespace geodrome {

/// Lemma 9 bounds an edge by psi at its end; carried out, its proof gives 4.96.
inline constexpr double face_edge_bound = 4.96;

/// The circumradius over psi beyond which a face closes a hole that the sample shows; Lemma 8 gives 2.056.
inline constexpr double face_radius_bound = 2.5;

}  // namespace geodrome
