// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace geodrome::bench {

/// The exponent p of the power law y = c x^p that fits best: least squares of log y over log x. NaN if fewer than two
/// different x are given. Preconditions: as many y as x, all positive.
double fitted_exponent(std::span<const double> x, std::span<const double> y);

}  // namespace geodrome::bench
