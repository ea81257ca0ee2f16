// SPDX-License-Identifier: MIT
#include "tools/bench/samples/claim_extremes.hpp"

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace geodrome::bench {

void ClaimExtremes::add(const PlacedSurface& surface, std::uint64_t seed) {
  for (const Claim& claim : claims_of(surface, seed)) {
    if (!claim.is_measured()) continue;
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.claim.name == claim.name; });
    if (row == rows_.end()) row = rows_.insert(row, {claim, claim.measured, claim.measured, 0, 0});
    row->least = std::min(row->least, claim.measured), row->most = std::max(row->most, claim.measured);
    row->held += claim.holds(), ++row->measured;
  }
}

void ClaimExtremes::print(std::ostream& out) const {
  if (rows_.empty()) return;
  char line[200];
  std::snprintf(line, sizeof line, "%-46s %-10s %10s %10s %10s   held in\n", "the paper's constants, right surfaces",
                "", "bound", "least", "most");
  out << line;
  for (const Row& row : rows_) {
    std::snprintf(line, sizeof line, "%-46s %-10s %10.4g %10.4g %10.4g   %zu of %zu\n", row.claim.name.c_str(),
                  row.claim.source.c_str(), row.claim.bound, row.least, row.most, row.held, row.measured);
    out << line;
  }
}

}  // namespace geodrome::bench
