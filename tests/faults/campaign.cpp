// SPDX-License-Identifier: MIT
#include "tests/faults/campaign.hpp"

#include <cstdio>

namespace geodrome::faults {

void Campaign::note(const std::string& kind, const std::string& job, const std::string& what, const Ended& ended,
                    const std::string& complaint) {
  Row& row = rows_[kind][job];
  ++row.tried, ++row.by_status[ended.status];
  if (complaint.empty()) return;
  ++row.wrong;
  std::printf("WRONG %s.%s, %s (status %d): %s\n%s\n", kind.c_str(), job.c_str(), what.c_str(), ended.status,
              complaint.c_str(), ended.err.c_str());
  std::fflush(stdout);
}

int Campaign::report() const {
  int tried = 0, wrong = 0;
  std::printf("%-16s %-10s %7s %7s  ends by status\n", "fault", "job", "tried", "wrong");
  for (const auto& [kind, jobs] : rows_)
    for (const auto& [job, row] : jobs) {
      std::printf("%-16s %-10s %7d %7d ", kind.c_str(), job.c_str(), row.tried, row.wrong);
      for (const auto& [status, count] : row.by_status) std::printf(" %d: %d", status, count);
      std::printf("\n");
      tried += row.tried, wrong += row.wrong;
    }
  std::printf("%d faults tried, %d survived\n", tried, tried - wrong);
  return tried == 0 ? 1 : wrong;
}

}  // namespace geodrome::faults
