// SPDX-License-Identifier: MIT
#include "engine/output/partial_matrix.hpp"

#include "engine/formats/source_file.hpp"
#include "tests/engine/output/matrix_file_fixture.hpp"

// The protocol of unfinished files, apart from any format.
namespace geodrome {
namespace {

/// A format with a long header that depends on the shape, as HDF5 or CIFTI have it.
std::string long_header(const MatrixShape& shape) {
  std::string header = "matrix of " + std::to_string(shape.rows) + " rows";
  header.resize(2048 + shape.rows, '.');
  return header;
}
constexpr DenseFormat long_format{long_header};

class PartialMatrixTest : public MatrixFileTest {
 protected:
  static void write_missing(PartialMatrix& matrix) {
    const MatrixFile::Spec& s = matrix.spec();
    for (std::uint64_t row = 0; row < s.rows; ++row)
      if (!matrix.has(row)) matrix.write(row, row_values(row, s.columns).data());
  }

  static std::string expected(const MatrixFile::Spec& s) {
    std::string bytes = long_header({s.rows, s.columns, s.scalar});
    for (std::uint64_t row = 0; row < s.rows; ++row) {
      const auto values = row_values(row, s.columns);
      bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
    }
    return bytes;
  }
};

TEST_F(PartialMatrixTest, IsPublishedAsHeaderAndRowsOfAnyFormat) {
  const auto s = spec("d.any");
  PartialMatrix matrix(s, long_format, 0, false);
  write_missing(matrix);
  matrix.publish();
  EXPECT_EQ(bytes_in(s.out), expected(s));
  EXPECT_EQ(files(), 1u);
}

TEST_F(PartialMatrixTest, GoesOnWithTheRowsOfAnyFormat) {
  const auto s = spec("d.any");
  {
    PartialMatrix matrix(s, long_format, 0, false);
    for (const std::uint64_t row : {0, 2, 3}) matrix.write(row, row_values(row, s.columns).data());
  }
  replace_byte(partial_of(s), 2048 + s.rows + 2 * 7 * 8);  // the first byte of row 2
  PartialMatrix matrix(s, long_format, 0, true);
  EXPECT_EQ(matrix.rows_done(), 2u);
  EXPECT_FALSE(matrix.has(2));
  write_missing(matrix);
  matrix.publish();
  EXPECT_EQ(bytes_in(s.out), expected(s));
}

TEST_F(PartialMatrixTest, OfAnotherFormatIsNotTakenForThisOne) {
  const auto s = spec("d.any");
  { PartialMatrix matrix(s, long_format, 0, false); }
  constexpr DenseFormat other{[](const MatrixShape&) { return std::string("other"); }};
  EXPECT_THROW(PartialMatrix(s, other, 0, true), RefusedError);
}

TEST_F(PartialMatrixTest, TellsTheShapeOfAnotherRunWhoseHeaderIsLonger) {
  { PartialMatrix matrix(spec("d.any", 50, 7), long_format, 0, false); }
  const std::string error = error_of([&] { PartialMatrix(spec("d.any", 6, 7), long_format, 0, true); });
  EXPECT_NE(error.find("the number of rows was 50 and is 6"), std::string::npos) << error;
}

TEST_F(PartialMatrixTest, SavesAWholeFooterThoughTheFingerprintIsSpelledOtherwise) {
  auto s = spec("d.any");
  { PartialMatrix matrix(s, long_format, 0, false); }
  s.fingerprint = R"({"seed":1,"solver":{"delta":0.5,"name":"exact"},"input":"abc"})" + std::string(200, ' ');
  PartialMatrix matrix(s, long_format, 0, true);
  write_missing(matrix);
  matrix.publish();
  EXPECT_EQ(bytes_in(s.out), expected(s));
}

/// Files of this layout lie on users' disks and must stay resumable: a change of one byte is a new version of the
/// footer.
TEST_F(PartialMatrixTest, HasTheLayoutOfVersionOneByteForByte) {
  const auto s = spec("d.npy");
  begin(s, 3);
  const std::string bytes = bytes_in(partial_of(s));
  EXPECT_EQ(bytes.size(), 640u);
  EXPECT_EQ(input::content_hash(bytes), "72368c5c106ee9138fcacc958fbc0e9d");
}

}  // namespace
}  // namespace geodrome
