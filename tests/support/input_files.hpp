// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <set>
#include <string>

#include "geodrome/engine/input.hpp"
#include "geodrome/errors.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::testing {

/// Reads bytes as if they were a file of that name.
inline Input read_bytes(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) {
  static const TemporaryFolder folder;  // one for all: making folders takes longer than reading
  const std::filesystem::path file = folder / name;
  std::ofstream(file, std::ios::binary) << bytes;
  return read_input(file, options);
}

/// The error that reading throws, or nothing if it succeeds.
template <class Read>
std::optional<InputError> error_of(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error;
  }
  return std::nullopt;
}

/// Expects that reading is refused with the fault, in a message that contains `part`.
template <class Read>
void expect_refused(Read&& read, InputFault fault, const std::string& part) {
  const std::optional<InputError> error = error_of(read);
  ASSERT_TRUE(error) << "was accepted";
  EXPECT_EQ(name(error->fault()), name(fault)) << error->what();
  EXPECT_NE(std::string(error->what()).find(part), std::string::npos) << error->what();
}

inline bool has_finding(const Input& input, const std::string& code) {
  for (const Finding& finding : input.findings)
    if (finding.code == code) return true;
  return false;
}

inline bool has_warning(const Input& input) {
  for (const Finding& finding : input.findings)
    if (finding.severity == Finding::Severity::warning) return true;
  return false;
}

/// Expects what every Input promises: finite positions, indices in range, a place for every row.
inline void expect_valid(const Input& input) {
  EXPECT_EQ(input.element_of_row.size(), input.facts.rows);
  EXPECT_EQ(input.face_of_triangle.size(), input.triangles.size());
  EXPECT_EQ(input.kind == InputKind::mesh, !input.triangles.empty());
  EXPECT_FALSE(input.positions.empty());
  for (const Vec3& p : input.positions) EXPECT_TRUE(is_finite(p));
  for (const Index element : input.element_of_row) EXPECT_TRUE(element == no_index || element < input.positions.size());
  for (const Index face : input.face_of_triangle) EXPECT_LT(face, input.facts.faces_in_file);
  for (const Triangle& t : input.triangles) {
    EXPECT_EQ(std::set<Index>(t.begin(), t.end()).size(), 3u);
    for (const Index v : t) EXPECT_LT(v, input.positions.size());
  }
  EXPECT_TRUE(std::isfinite(input.facts.bounding_box_diagonal));
}

}  // namespace geodrome::testing
