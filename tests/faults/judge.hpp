// SPDX-License-Identifier: MIT
#pragma once

#include <set>

#include "tests/faults/lab.hpp"

namespace geodrome::faults {

/// What a run may come to under a fault, and what its message must name.
struct Expected {
  std::set<int> statuses{0, 3};
  std::vector<std::string> words = {};  ///< in the message of a run that failed
  std::string warning;                  ///< on standard error, whatever the end
  bool may_be_killed = false;           ///< then it could not tidy up
  bool may_leave_footer = false;        ///< of a matrix that is done, since files cannot be removed
};

/// Judges what runs of a job leave behind, against a run without faults.
class Judge {
 public:
  /// Runs the job without faults. Throws if that fails.
  Judge(Lab& lab, const Job& job);

  const Job& job() const { return job_; }
  double seconds() const { return seconds_; }

  /// Prepares the folder, runs the job and gives what is wrong with its end, and with running it once more without
  /// faults; empty if nothing is. `ended`: how it ended.
  std::string trial(const Conditions& conditions, const Expected& expected, Ended& ended, const std::string& old = {});

  /// What is wrong with the end of a run. `old`: what the outputs held before.
  std::string complaint(const Ended& ended, const Expected& expected, const std::string& old = {}) const;
  /// Runs the job again where it was left, and gives what is wrong then.
  std::string complaint_of_second_run() const;
  std::string complaint_of_outputs(const Files& files, const std::string& old, bool all) const;

 private:
  std::string complaint_of_leftovers(const Files& files, bool done, const Expected& expected) const;

  Lab& lab_;
  Job job_;
  Files outputs_;  ///< comparable
  double seconds_ = 0;
};

/// Rows of the job's unfinished matrix that are on record among the files: in its footer, or all, where that was cut
/// off and saved to give the matrix its name.
std::uint64_t rows_on_record(const Files& files, const Job& job);

}  // namespace geodrome::faults
