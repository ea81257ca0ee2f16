// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace geodrome::faults {

/// A run of the program that faults are tried on. Files are named within the folder that it works on.
struct Job {
  std::string name;
  std::vector<std::string> arguments;  ///< a "%" stands for the folder
  std::vector<std::string> reads;      ///< the files that it reads
  std::vector<std::string> outputs;    ///< the files that it promises, the matrix first
  std::uint64_t rows = 0;       ///< of its matrix, which stays unfinished and can be gone on with; 0: it has none
  bool tells_failures = false;  ///< in its output: what did not run is a row with the reason there
  std::map<std::string, std::string> before = {};  ///< the content of files that are there when it starts
};

/// The contents of all input files of the jobs, made by the program itself.
using Files = std::map<std::string, std::string>;

/// What an output is compared by: its bytes, of a JSON report those without times and memory. Throws if it is no JSON.
std::string comparable(const std::string& file, const std::string& bytes);

}  // namespace geodrome::faults
