// SPDX-License-Identifier: MIT
#include "engine/formats/npy_matrix.hpp"

#include <gtest/gtest.h>

#include "engine/formats/npy.hpp"
#include "engine/jobs/compare/truth.hpp"
#include "tests/support/input_files.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

template <class Number>
std::string entries(std::initializer_list<Number> values) {
  return {reinterpret_cast<const char*>(values.begin()), values.size() * sizeof(Number)};
}

/// A file of format version 1 with this dictionary.
std::string npy(const std::string& dictionary, const std::string& bytes, char version = 1) {
  std::string text = std::string("\x93NUMPY") + version + '\0';
  text += static_cast<char>(dictionary.size() & 0xff), text += static_cast<char>(dictionary.size() >> 8);
  return text + std::string(version == 1 ? 0 : 2, '\0') + dictionary + bytes;
}

class NpyReader : public ::testing::Test {
 protected:
  NpyMatrix open(const std::string& bytes) {
    write_bytes(folder_ / "t.npy", bytes);
    return NpyMatrix(folder_ / "t.npy");
  }
  void expect_refused(const std::string& bytes, InputFault fault, const std::string& word) {
    testing::expect_refused([&] { open(bytes); }, fault, word);
  }

  TemporaryFolder folder_;
  const std::string dictionary_ = "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }\n";
  const std::string six_ = entries<double>({0, 1, 2, 3, inf, 5.5});
};

TEST_F(NpyReader, GivesRowsInAnyOrder) {
  NpyMatrix matrix = open(npy_header(2, 3, ScalarType::float64) + six_);
  EXPECT_EQ(matrix.rows(), 2u);
  EXPECT_EQ(matrix.columns(), 3u);
  EXPECT_EQ(matrix.read(1), (std::vector<double>{3, inf, 5.5}));
  EXPECT_EQ(matrix.read(0), (std::vector<double>{0, 1, 2}));
}

TEST_F(NpyReader, WidensSinglePrecision) {
  NpyMatrix matrix = open(npy_header(2, 2, ScalarType::float32) + entries<float>({0, 0.5f, 0.1f, 2}));
  EXPECT_EQ(matrix.scalar(), ScalarType::float32);
  EXPECT_EQ(matrix.read(1), (std::vector<double>{0.1f, 2}));
}

TEST_F(NpyReader, TakesOtherVersionsAndOrdersOfKeys) {
  EXPECT_EQ(open(npy(dictionary_, six_, 2)).read(0), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(open(npy("{'shape':(2,3),'fortran_order':False,'descr':'<f8'}", six_, 3)).columns(), 3u);
}

TEST_F(NpyReader, RefusesOtherTypesOrdersAndDimensions) {
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = dictionary_;
    return npy(changed.replace(changed.find(from), from.size(), to), six_);
  };
  expect_refused(with("<f8", ">f8"), InputFault::unsupported, ">f8");
  expect_refused(with("<f8", "<i8"), InputFault::unsupported, "<i8");
  expect_refused(with("'<f8'", "[('x', '<f8')]"), InputFault::unsupported, "compound");
  expect_refused(with("False", "True"), InputFault::unsupported, "Fortran");
  expect_refused(with("(2, 3)", "(6,)"), InputFault::unsupported, "(6,)");
  expect_refused(with("(2, 3)", "(1, 2, 3)"), InputFault::unsupported, "(1, 2, 3)");
  expect_refused(with("(2, 3)", "()"), InputFault::unsupported, "()");
  expect_refused(with("(2, 3)", "(99999999999999999999, 3)"), InputFault::unsupported, "shape");
}

TEST_F(NpyReader, TakesHeadersOfAnyLengthAndShowsTheirStart) {
  const std::string blanks(60'000, ' '), many(60'000, '1');
  EXPECT_EQ(open(npy("{'descr':" + blanks + "'<f8', 'fortran_order': False, 'shape': (2, 3), }", six_)).rows(), 2u);
  expect_refused(npy("{'descr': '" + many + "', 'fortran_order': False, 'shape': (2, 3), }", six_),
                 InputFault::unsupported, "1111...'");
  expect_refused(npy("{'descr': '<f8', 'fortran_order': False, 'shape': (" + many + ", 3), }", six_),
                 InputFault::unsupported, "1111..., which is no matrix");
}

TEST_F(NpyReader, TakesKeysForKeysOnly) {
  expect_refused(npy("{'descr': [('shape', '<f8')], 'fortran_order': False, 'shape': (2, 3), }", six_),
                 InputFault::unsupported, "compound");
  EXPECT_EQ(open(npy("{'shape' : ( 2 , 3 , ) , 'fortran_order' : False , 'descr' : '<f8'}", six_)).columns(), 3u);
  for (const std::string shape : {"(2, 3", "(2 3)", "(2, 3, 4)", "(-2, 3)", "2, 3"})
    EXPECT_TRUE(error_of([&] { open(npy("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape, six_)); }))
        << shape;
}

TEST_F(NpyReader, RefusesWhatIsNoneOrHasNotItsBytes) {
  expect_refused("", InputFault::syntax, "no .npy");
  expect_refused("PK\x03\x04 an archive", InputFault::syntax, "no .npy");
  expect_refused(npy("{'descr': '<f8'}", six_), InputFault::syntax, "damaged");
  expect_refused(npy(dictionary_, six_, 9), InputFault::unsupported, "version 9");
  expect_refused(npy(dictionary_, six_).substr(0, 30), InputFault::truncated, "header");
  expect_refused(npy(dictionary_, six_.substr(1)), InputFault::truncated, "47 bytes");
  expect_refused(npy(dictionary_, six_ + "x"), InputFault::truncated, "(2, 3)");
  const std::string huge = "{'descr': '<f8', 'fortran_order': False, 'shape': (4294967296, 4294967296), }";
  expect_refused(npy(huge, six_), InputFault::truncated, "takes");
  testing::expect_refused([&] { NpyMatrix(folder_ / "none.npy"); }, InputFault::io, "none.npy");
}

/// The truth of a comparison: rows of such a file.
class TruthRows : public NpyReader {
 protected:
  DistanceRows rows(const std::vector<NamedPoint>& sources, std::uint64_t rows_of_file, const std::string& bytes) {
    NpyMatrix matrix = open(npy_header(rows_of_file, 3, ScalarType::float64) + bytes);
    return rows_of_sources(matrix, "t.npy", sources, 3);
  }
  static NamedPoint row(Index i, double start = 0) { return {{}, start, i, std::to_string(i)}; }
  const std::string nine_ = entries<double>({0, 1, 2, 1, 0, 3, 2, 3, 0});
};

TEST_F(TruthRows, AreThoseOfTheSourcesInTheirOrder) {
  EXPECT_EQ(rows({row(2), row(0)}, 2, six_), (DistanceRows{{0, 1, 2}, {3, inf, 5.5}}));
}

TEST_F(TruthRows, AreTakenFromAllPairsByTheRowsOfTheSources) {
  EXPECT_EQ(rows({row(2), row(0, 10)}, 3, nine_), (DistanceRows{{2, 3, 0}, {10, 11, 12}}));
}

TEST_F(TruthRows, OfAnotherShapeAreRefusedWithBothShapes) {
  testing::expect_refused([&] { rows({row(0)}, 2, six_); }, InputFault::unsupported,
                          "has shape (2, 3), but must have (1, 3) (sources x rows of the input) or (3, 3)");
}

TEST_F(TruthRows, OfASourceThatIsNoRowAreNotInAllPairs) {
  NamedPoint point;
  point.label = "@1";
  testing::expect_refused([&] { rows({row(0), point}, 3, nine_); }, InputFault::index, "@1");
}

TEST_F(TruthRows, ThatAreNoDistancesAreRefused) {
  testing::expect_refused(
      [&] {
        rows({row(0)}, 1, entries<double>({0, -1, 2}));
      },
      InputFault::range, "row 0, column 1");
}

TEST_F(TruthRows, ThatAreLongerThanAnyPathAreRefusedAsUnreachableInDisguise) {
  for (const double huge : {std::numeric_limits<double>::max(), double{std::numeric_limits<float>::max()}, 1e100, 10.5})
    testing::expect_refused(
        [&] {
          NpyMatrix matrix = open(npy_header(1, 3, ScalarType::float64) + entries<double>({0, 1, huge}));
          rows_of_sources(matrix, "t.npy", std::vector{row(0)}, 3, 10);
        },
        InputFault::range, "t.npy: row 0, column 2 is");
  NpyMatrix single =
      open(npy_header(1, 3, ScalarType::float32) + entries<float>({0, 1, std::numeric_limits<float>::max()}));
  const std::vector sources{row(0)};
  testing::expect_refused([&] { rows_of_sources(single, "t.npy", sources, 3, 10); }, InputFault::range,
                          "write inf for unreachable");
  NpyMatrix sound = open(npy_header(1, 3, ScalarType::float64) + entries<double>({0, 10, inf}));
  EXPECT_EQ(rows_of_sources(sound, "t.npy", sources, 3, 10), (DistanceRows{{0, 10, inf}}));
}

}  // namespace
}  // namespace geodrome::testing
