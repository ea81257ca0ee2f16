// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geodrome/finding.hpp"
#include "geodrome/remedy.hpp"

// Exceptions cross the border between a plugin and the engine, so their type information must be visible on both sides.
#if defined(__GNUC__)
#define GEODROME_VISIBLE __attribute__((visibility("default")))
#else
#define GEODROME_VISIBLE
#endif

namespace geodrome {

/// Base of everything that Geodrome throws: what is wrong, and what the user can do about it.
/// The host adds the plugin's name with `attribute_to` when an error leaves a plugin.
class GEODROME_VISIBLE Error : public std::runtime_error {
 public:
  explicit Error(std::string message, Remedy remedy = {})
      : std::runtime_error(message), message_(std::move(message)), remedy_(std::move(remedy)) {
    compose();
  }

  const char* what() const noexcept override { return text_.c_str(); }
  /// The kind of this error, for programs: "input.truncated", "option", "capability", "sample", "refused", "plugin",
  /// "numerical", "cancelled".
  virtual std::string_view code() const noexcept { return "error"; }
  const std::string& message() const noexcept { return message_; }
  /// The remedy in the words of the library; empty if there is none.
  const std::string& remedy() const noexcept { return remedy_.text; }
  /// The remedy with its code and parameters, for programs that have words of their own.
  const Remedy& coded_remedy() const noexcept { return remedy_; }
  const std::string& plugin() const noexcept { return plugin_; }

  /// Names the plugin that the error came from, once; later calls change nothing.
  void attribute_to(std::string_view plugin) {
    if (plugin_.empty()) plugin_ = plugin;
    compose();
  }

 private:
  void compose() {
    text_ = plugin_.empty() ? message_ : plugin_ + ": " + message_;
    if (!remedy_.empty()) text_ += "; " + remedy_.text;
  }

  std::string message_, plugin_, text_;
  Remedy remedy_;
};

/// The fault of an input; `name` gives the word that messages and reports use.
enum class InputFault {
  io,           ///< a file cannot be opened, read or written
  empty,        ///< there is nothing in it, or no point and no face
  syntax,       ///< it does not follow its format
  truncated,    ///< it ends before what it announced
  index,        ///< an index names a point, vertex or face that is not there, or counts do not match
  nonfinite,    ///< a number is infinite or none
  range,        ///< a number is too large, too small or of the wrong sign: a coordinate beyond 1e100, a weight of 0
  unsupported,  ///< it follows its format, but this part of the format is not read
  degenerate,   ///< there is no geometry in it: a face that repeats a vertex, all points at one place
  nonmanifold   ///< the surface is no 2-manifold, and nothing else would do
};

/// "input.io" and so on: `Error::code` of an InputError.
constexpr std::string_view code(InputFault fault) {
  constexpr std::string_view codes[] = {"input.io",         "input.empty",      "input.syntax", "input.truncated",
                                        "input.index",      "input.nonfinite",  "input.range",  "input.unsupported",
                                        "input.degenerate", "input.nonmanifold"};
  return codes[static_cast<std::size_t>(fault)];
}

/// The word for a fault in messages: "io" and so on.
constexpr std::string_view name(InputFault fault) { return code(fault).substr(6); }

/// The input cannot be read or cannot be used. The message names file and element.
class GEODROME_VISIBLE InputError : public Error {
 public:
  InputError(InputFault fault, std::string message, Remedy remedy = {})
      : Error(std::string(name(fault)) + ": " + message, std::move(remedy)), fault_(fault) {}
  InputFault fault() const noexcept { return fault_; }
  std::string_view code() const noexcept override { return geodrome::code(fault_); }

 private:
  InputFault fault_;
};

/// An option, an option's value, or a name the user gave does not exist or is out of range.
class GEODROME_VISIBLE OptionError : public Error {
 public:
  using Error::Error;
  std::string_view code() const noexcept override { return "option"; }
};

/// A request goes beyond what a plugin `provides`, or a surface lacks what it `needs`.
class GEODROME_VISIBLE CapabilityError : public Error {
 public:
  using Error::Error;
  std::string_view code() const noexcept override { return "capability"; }
};

/// The sample, or the surface made from it, is not fit: too sparse, no 2-manifold, too noisy. `findings` say where, for
/// the sample report; their elements are sample points.
class GEODROME_VISIBLE SampleError : public Error {
 public:
  explicit SampleError(std::string message, Remedy remedy = {}, std::vector<Finding> findings = {})
      : Error(std::move(message), std::move(remedy)), findings_(std::move(findings)) {}
  const std::vector<Finding>& findings() const noexcept { return findings_; }
  std::string_view code() const noexcept override { return "sample"; }

 private:
  std::vector<Finding> findings_;
};

/// The engine declines a job that could be done but should not be: not enough disk, too large without consent.
class GEODROME_VISIBLE RefusedError : public Error {
 public:
  using Error::Error;
  std::string_view code() const noexcept override { return "refused"; }
};

/// A plugin cannot be loaded, or failed in a way of its own.
class GEODROME_VISIBLE PluginError : public Error {
 public:
  using Error::Error;
  std::string_view code() const noexcept override { return "plugin"; }
};

/// A computation lost the precision it needs, or an invariant that the theory promises does not hold.
class GEODROME_VISIBLE NumericalError : public Error {
 public:
  using Error::Error;
  std::string_view code() const noexcept override { return "numerical"; }
};

/// The user asked to stop.
class GEODROME_VISIBLE Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
  std::string_view code() const noexcept override { return "cancelled"; }
};

}  // namespace geodrome
