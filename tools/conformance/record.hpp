// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <sstream>
#include <string>

#include "geodrome/errors.hpp"

namespace geodrome::conformance {

/// Leaves a demand that does not apply to the plugin, with the reason.
struct NotApplicable {
  std::string why;
};

/// The words one after the other; numbers so that they read back to the same value.
template <class... Words>
std::string text(const Words&... words) {
  std::ostringstream out;
  out.precision(17);
  ((void)(out << words), ...);
  return out.str();
}

template <class E>
constexpr const char* error_name() {
  if constexpr (std::same_as<E, InputError>) return "InputError";
  if constexpr (std::same_as<E, CapabilityError>) return "CapabilityError";
  if constexpr (std::same_as<E, SampleError>) return "SampleError";
  if constexpr (std::same_as<E, Cancelled>) return "Cancelled";
  return "an error of Geodrome";
}

/// Counts the checks of one demand and keeps the first that failed. `where` is any list of words and numbers; they are
/// put together only if the check fails.
class Record {
 public:
  /// Two numbers that are equal or differ by at most `tolerance`; both may be infinite.
  template <class... Where>
  void near(double found, double expected, double tolerance, const Where&... where) {
    const double apart = found > expected ? found - expected : expected - found;
    check(
        found == expected || apart <= tolerance, [&] { return text(expected, " within ", tolerance); }, found,
        where...);
  }
  template <class... Where>
  void at_most(double found, double bound, const Where&... where) {
    check(
        found <= bound, [&] { return text("at most ", bound); }, found, where...);
  }
  template <class... Where>
  void at_least(double found, double bound, const Where&... where) {
    check(
        found >= bound, [&] { return text("at least ", bound); }, found, where...);
  }
  template <class A, class B, class... Where>
  void equal(const A& found, const B& expected, const Where&... where) {
    check(
        found == expected, [&] { return text(expected); }, found, where...);
  }
  template <class... Where>
  void holds(bool it_does, const char* what, const Where&... where) {
    check(
        it_does, [&] { return std::string(what); }, "it does not hold", where...);
  }
  /// `function` throws an E.
  template <class E, class Function, class... Where>
  void throws(Function&& function, const Where&... where) {
    std::string found = "nothing thrown";
    bool right = false;
    try {
      function();
    } catch (const E&) {
      right = true;
    } catch (const std::exception& error) {
      found = text("threw: ", error.what());
    }
    check(
        right, [] { return text(error_name<E>(), " thrown"); }, found, where...);
  }

  std::size_t checks() const { return checks_; }
  std::size_t failures() const { return failures_; }
  const std::string& expected() const { return expected_; }
  const std::string& found() const { return found_; }
  const std::string& where() const { return where_; }

 private:
  template <class Expected, class Found, class... Where>
  void check(bool right, Expected&& expected, const Found& found, const Where&... where) {
    ++checks_;
    if (right || failures_++ > 0) return;
    expected_ = expected(), found_ = text(found), where_ = text(where...);
  }

  std::size_t checks_ = 0, failures_ = 0;
  std::string expected_, found_, where_;
};

}  // namespace geodrome::conformance
