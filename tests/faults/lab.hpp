// SPDX-License-Identifier: MIT
#pragma once

#include <sys/resource.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/faults/job.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::faults {

/// A fault of the system, as shim/fault_plan.hpp has it.
struct Fault {
  std::string call;
  std::string path;  ///< relative to the folder; the folder itself if empty
  unsigned long at = 0;
  int error = 0;
  unsigned long times = 1;
  long shortened = -1;
  std::string act;

  std::string text() const;
};

/// What a run is up against.
struct Conditions {
  std::optional<Fault> fault;
  rlim_t address_space = RLIM_INFINITY, file_size = RLIM_INFINITY;
  int signal = 0;  ///< sent after `after` seconds
  double after = 0;
  int ignored = 0;  ///< a signal that the program is started to ignore, as nohup does
  std::string out;  ///< in place of standard output: /dev/full; "closed" is a pipe that nobody reads
};

struct Ended {
  static constexpr int hangs = -1;

  int status = hangs;  ///< exit status; 128 + signal if killed
  std::string out, err;
  unsigned long calls = 0;  ///< that counted
  bool struck = false;      ///< by the fault
  double seconds = 0;
};

/// A folder with the inputs, on which jobs work one after the other.
class Lab {
 public:
  /// Works in a folder of its own, or in `place`.
  explicit Lab(std::string program, const std::filesystem::path& place = {});

  const std::string& program() const { return program_; }

  /// The folder as it is before the job: with its inputs and nothing else, the outputs holding `old` unless it is
  /// empty.
  void prepare(const Job& job, const std::string& old = {});
  /// A "%" in an argument stands for the folder with its slash.
  Ended run(const std::vector<std::string>& arguments, const Conditions& conditions = {}) const;

  /// The files of the folder, by name.
  Files files() const;
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  /// Adds an input.
  void add(const std::string& name, const std::string& bytes) { inputs_[name] = bytes; }
  const std::string& input(const std::string& name) const { return inputs_.at(name); }
  /// Runs the program and keeps the file that it made as an input. Throws if it fails.
  void make(const std::string& name, const std::vector<std::string>& arguments);

 private:
  std::string program_;
  testing::TemporaryFolder records_;
  std::filesystem::path folder_;
  Files inputs_;
};

}  // namespace geodrome::faults
