// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <string>
#include <vector>

namespace geodrome {

/// An exception as a few strings, to be told to another process: its kind, message, plugin and remedy. Findings of a
/// SampleError are left out.
std::vector<std::string> told(const std::exception& error);

/// Throws it there: a geodrome::Error of the same kind that says the same, std::bad_alloc, or a std::runtime_error.
[[noreturn]] void throw_told(const std::vector<std::string>& told);

}  // namespace geodrome
