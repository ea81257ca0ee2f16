// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geodrome/errors.hpp"

/// Readers and what they promise of any bytes whatever. libFuzzer runs the checks on inputs of its own (run.sh), the
/// normal suite on the seeds, on mutations of them, and on what libFuzzer found (replay_test.cpp).
namespace geodrome::fuzzing {

/// A promise that a reader did not keep.
struct Broken : std::logic_error {
  using std::logic_error::logic_error;
};

inline void demand(bool kept, const char* promise) {
  if (!kept) throw Broken(promise);
}

/// A reader under test.
struct Target {
  std::string_view name;
  /// Reads an input and throws Broken for a promise that is not kept. Lets pass what is thrown that is no refusal. The
  /// same input gives the same result.
  void (*check)(std::string_view input);
  /// Sound inputs of all sorts, the same on every call.
  std::vector<std::string> (*seeds)();
};

std::span<const Target> targets();

/// The first byte of an input chooses how the rest of it is read.
class Choices {
 public:
  explicit Choices(std::string_view input) : byte_(input.empty() ? 0 : static_cast<unsigned char>(input[0])) {}

  bool bit(int place) const { return byte_ >> place & 1; }
  /// The number that `count` bits from `place` on make.
  unsigned bits(int place, int count) const { return byte_ >> place & ((1u << count) - 1); }

 private:
  unsigned byte_;
};

inline std::string_view rest_of(std::string_view input) { return input.substr(input.empty() ? 0 : 1); }

/// Demands of text that is shown to people: that it has no control characters and is no longer than a few lines.
void demand_fit_to_show(const std::string& text);

/// Demands of a refusal that it is fit to show and names the file, and of a line that it names that `bytes` has it.
void demand_clear(const Error& error, std::string_view file, std::string_view bytes);

/// The result of `read()`, or nothing if it refuses with a message that names `file` and is clear.
template <class Read>
auto read_or_refusal(std::string_view file, std::string_view bytes, Read&& read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Error& error) {
    demand_clear(error, file, bytes);
    return std::nullopt;
  }
}

/// The same text with its lines ended as Windows does it. Precondition: it has no carriage return.
std::string with_windows_line_ends(std::string_view text);

}  // namespace geodrome::fuzzing
