// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "geodrome/errors.hpp"

namespace geodrome::input {

/// Where an input comes from, and so what messages call its elements: a file, or arrays of the caller.
class Origin {
 public:
  explicit Origin(std::filesystem::path file) : file_(std::move(file)) {}
  static Origin arrays() { return Origin({}); }

  bool is_file() const { return !file_.empty(); }
  const std::filesystem::path& file() const { return file_; }

  /// "vertex 17 (from 0)", or "positions[17]".
  std::string vertex(std::size_t v) const {
    return is_file() ? "vertex " + std::to_string(v) + " (from 0)" : "positions[" + std::to_string(v) + "]";
  }
  /// "point 17 (from 0)", or "positions[17]": the name of a point of a cloud.
  std::string point(std::size_t p) const { return is_file() ? "point " + std::to_string(p) + " (from 0)" : vertex(p); }
  /// "face 3", or "faces[3]".
  std::string face(std::size_t f) const {
    return is_file() ? "face " + std::to_string(f) : "faces[" + std::to_string(f) + "]";
  }

  /// Throws InputError with a message that starts with the file's name, if there is a file.
  [[noreturn]] void reject(InputFault fault, const std::string& what, Remedy remedy = {}) const {
    throw InputError(fault, (is_file() ? file_.string() + ": " : "") + what, std::move(remedy));
  }

 private:
  std::filesystem::path file_;
};

}  // namespace geodrome::input
