// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <utility>

#include "engine/checks/claims.hpp"

namespace geodrome {

/// A claim in the making: the worst value of each point, and of all.
class Gauge {
 public:
  Gauge(const char* code, const char* name, const char* source, Claim::Sense sense, double bound, std::size_t points)
      : worst_(points, std::numeric_limits<double>::quiet_NaN()) {
    claim_.code = code, claim_.name = name, claim_.source = source;
    claim_.sense = sense, claim_.bound = bound;
  }

  /// `point` may be no_index: the value counts, without a place.
  void add(Index point, double measured) {
    if (std::isnan(measured)) return;
    if (exceeds(measured, claim_.measured)) claim_.measured = measured;
    if (point != no_index && exceeds(measured, worst_[point])) worst_[point] = measured;
  }

  Claim finish(const char* if_not_measured) && {
    for (Index i = 0; i < worst_.size(); ++i)
      if (!std::isnan(worst_[i])) claim_.places.push_back({i, worst_[i]});
    std::stable_sort(claim_.places.begin(), claim_.places.end(), [this](const PlacedValue& a, const PlacedValue& b) {
      return claim_.strain(a.measured) > claim_.strain(b.measured);
    });
    if (!claim_.is_measured()) claim_.not_measured = if_not_measured;
    return std::move(claim_);
  }

 private:
  bool exceeds(double value, double other) const {
    return std::isnan(other) || claim_.strain(value) > claim_.strain(other);
  }

  Claim claim_;
  std::vector<double> worst_;
};

}  // namespace geodrome
