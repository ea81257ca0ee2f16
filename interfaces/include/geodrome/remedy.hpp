// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace geodrome {

/// The remedy for an error or a finding, which says what a user can do: a sentence and, where a program may want to say
/// it in words of its own, a stable code with parameters. The sentence speaks of members and functions, never of the
/// flags of a command line. Plugins may give the sentence alone.
struct Remedy {
  Remedy() = default;
  Remedy(std::string sentence) : text(std::move(sentence)) {}  // NOLINT: a sentence is a remedy
  Remedy(const char* sentence) : text(sentence) {}             // NOLINT
  Remedy(std::string remedy_code, std::vector<std::string> values, std::string sentence)
      : text(std::move(sentence)), code(std::move(remedy_code)), parameters(std::move(values)) {}

  bool empty() const noexcept { return text.empty(); }

  std::string text;                     ///< in the words of the library; empty: there is no remedy
  std::string code;                     ///< lower case with dots, for programs: "consent"; empty: there is only `text`
  std::vector<std::string> parameters;  ///< what the sentence of that code speaks of, in a fixed order
};

}  // namespace geodrome
