// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <random>

#include "tests/faults/judge.hpp"

namespace geodrome::faults {

/// How much is tried, and what was found.
class Campaign {
 public:
  Campaign(Lab& lab, std::vector<Job> jobs, bool all, std::uint64_t seed, std::string only)
      : lab(lab), jobs(std::move(jobs)), all(all), random(seed), only_(std::move(only)) {}

  Lab& lab;
  const std::vector<Job> jobs;
  const bool all;  ///< everything, not only what the suite tries
  std::mt19937_64 random;

  /// True if faults of this kind are to be tried on this job: if "KIND.JOB" contains what is asked for.
  bool wants(const std::string& kind, const std::string& job) const {
    return only_.empty() || (kind + "." + job).find(only_) != std::string::npos;
  }
  /// Notes one trial. `what`: the fault in words; `complaint`: what is wrong with what came of it, or empty.
  void note(const std::string& kind, const std::string& job, const std::string& what, const Ended& ended,
            const std::string& complaint);
  /// One of the numbers from 0 to `below` - 1.
  std::uint64_t any(std::uint64_t below) { return random() % below; }

  /// Prints the table. Returns how many trials went wrong, at least 1 if nothing was tried.
  int report() const;

 private:
  struct Row {
    int tried = 0, wrong = 0;
    std::map<int, int> by_status;
  };
  std::string only_;
  std::map<std::string, std::map<std::string, Row>> rows_;
};

void try_calls(Campaign& campaign);    ///< every call into the system fails once, or for good, or moves few bytes
void try_changes(Campaign& campaign);  ///< files that are read change meanwhile
void try_signals(Campaign& campaign);  ///< SIGKILL, SIGTERM, SIGINT at each call and at random moments
void try_memory(Campaign& campaign);   ///< allocations fail, the address space ends, threads cannot be started
void try_places(Campaign& campaign);   ///< full and read-only file systems, limits of files, streams

}  // namespace geodrome::faults
