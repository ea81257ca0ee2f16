// SPDX-License-Identifier: MIT
#pragma once

#include "tests/faults/lab.hpp"

namespace geodrome::faults {

/// The jobs that faults are tried on: together they read and write everything that the program reads and writes. Makes
/// their inputs in the lab.
std::vector<Job> make_jobs(Lab& lab);

/// The job of a name. Throws if there is none.
const Job& job_named(const std::vector<Job>& jobs, const std::string& name);

}  // namespace geodrome::faults
