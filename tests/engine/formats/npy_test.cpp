// SPDX-License-Identifier: MIT
#include "engine/formats/npy.hpp"

#include <gtest/gtest.h>

#include <string>

#include "engine/formats/csv.hpp"

namespace geodrome {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

std::string csv_of(std::vector<double> values, ScalarType scalar = ScalarType::float64) {
  std::string text;
  append_csv_row(text, values, scalar);
  return text;
}

TEST(NpyHeader, IsVersionOneByteForByte) {
  std::string expected("\x93NUMPY\x01\x00\x76\x00", 10);
  expected += "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }";
  expected.resize(127, ' ');
  expected += '\n';
  EXPECT_EQ(npy_header(3, 4, ScalarType::float64), expected);
}

TEST(NpyHeader, NamesSinglePrecision) {
  EXPECT_NE(npy_header(3, 4, ScalarType::float32).find("'descr': '<f4'"), std::string::npos);
}

TEST(NpyHeader, OfAVectorHasAShapeOfOneNumber) {
  EXPECT_NE(npy_header(7, ScalarType::float64).find("'shape': (7,), }"), std::string::npos);
}

TEST(NpyHeader, EndsAtAMultipleOf64AndStatesItsLength) {
  for (std::uint64_t rows = 0, step = 1; rows < std::uint64_t{1} << 60; rows += step, step *= 3) {
    const std::string header = npy_header(rows, step, ScalarType::float64);
    const std::size_t stated = static_cast<unsigned char>(header[8]) + 256u * static_cast<unsigned char>(header[9]);
    EXPECT_EQ(header.size() % 64, 0u) << rows;
    EXPECT_EQ(header.size(), 10 + stated) << rows;
    EXPECT_EQ(header.back(), '\n') << rows;
  }
}

TEST(CsvRow, WritesTheShortestTextThatReadsBack) {
  EXPECT_EQ(csv_of({0, 0.1, 1.0 / 3, 1e300}), "0,0.1,0.3333333333333333,1e+300\n");
}

TEST(CsvRow, WritesUnreachableAndNotComputed) {
  EXPECT_EQ(csv_of({inf, std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN()}),
            "inf,nan,nan\n");
}

TEST(CsvRow, WritesSinglePrecisionAsSuch) {
  EXPECT_EQ(csv_of({static_cast<double>(0.1f)}, ScalarType::float32), "0.1\n");
}

TEST(CsvRow, NeverTakesMoreThanItsBound) {
  for (const double value : {-2.2250738585072014e-308, -1.7976931348623157e308, -4.9406564584124654e-324})
    EXPECT_LE(csv_of({value}).size(), csv_bytes_per_entry);
}

TEST(CsvRow, EndsAnEmptyRowWithANewline) { EXPECT_EQ(csv_of({}), "\n"); }

}  // namespace
}  // namespace geodrome
