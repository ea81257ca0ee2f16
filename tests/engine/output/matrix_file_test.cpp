// SPDX-License-Identifier: MIT
#include <signal.h>
#include <sys/resource.h>

#include <cmath>
#include <thread>

#include "tests/engine/output/matrix_file_fixture.hpp"

namespace geodrome {
namespace {

TEST_F(MatrixFileTest, WritesTheNpyByteForByteAndNothingElse) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  for (const std::uint64_t row : {3, 0, 4, 1, 2}) matrix.write(row, row_values(row, s.columns));
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
  EXPECT_EQ(bytes_in(s.out).size(), MatrixFile::bytes(s));
  EXPECT_EQ(files(), 1u);
}

TEST_F(MatrixFileTest, StoresSinglePrecision) {
  auto s = spec("d.npy");
  s.scalar = ScalarType::float32;
  MatrixFile matrix = MatrixFile::open(s, false);
  write_missing(matrix, s);
  EXPECT_EQ(matrix.read(2)[0], static_cast<double>(static_cast<float>(row_values(2, s.columns)[0])));
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
}

TEST_F(MatrixFileTest, RefusesADistanceThatSinglePrecisionWouldChangeInKind) {
  auto s = spec("d.npy", 1, 2);
  s.scalar = ScalarType::float32;
  MatrixFile matrix = MatrixFile::open(s, false);
  EXPECT_NE(error_of([&] {
              matrix.write(0, std::vector<double>{1, 1e300});
            }).find("1e+300 (row 0, column 1"),
            std::string::npos);
  EXPECT_THROW(matrix.write(0, std::vector<double>{1e-300, 1}), OptionError);
  EXPECT_FALSE(matrix.has(0));
}

TEST_F(MatrixFileTest, WritesTheCsvAndNothingElse) {
  const auto s = spec("d.csv", 2, 3);
  MatrixFile matrix = MatrixFile::open(s, false);
  matrix.write(1, std::vector<double>{inf, std::nan(""), 1e-9});
  matrix.write(0, std::vector<double>{0, 0.1, 2.0 / 3});
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), "0,0.1,0.6666666666666666\ninf,nan,1e-09\n");
  EXPECT_EQ(files(), 1u);
}

TEST_F(MatrixFileTest, KeepsThePartialIfTheTextCannotBeWritten) {
  const auto s = spec("d.csv", 2, 3);
  MatrixFile matrix = MatrixFile::open(s, false);
  write_missing(matrix, s);
  fs::create_directory(s.out);
  EXPECT_THROW(matrix.finish(), InputError);
  EXPECT_TRUE(fs::exists(partial_of(s)));
  EXPECT_EQ(files(), 2u);  // the folder in the way and the partial
}

TEST_F(MatrixFileTest, WritesMatricesWithoutRowsOrColumns) {
  for (const auto& s : {spec("rows.npy", 0, 7), spec("columns.npy", 7, 0)}) {
    MatrixFile matrix = MatrixFile::open(s, false);
    write_missing(matrix, s);
    matrix.finish();
    EXPECT_EQ(bytes_in(s.out), expected_npy(s));
  }
}

TEST_F(MatrixFileTest, ReadsBackWhatWasWritten) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  matrix.write(3, row_values(3, s.columns));
  EXPECT_EQ(matrix.read(3), row_values(3, s.columns));
  EXPECT_THROW(matrix.read(2), std::out_of_range);
}

TEST_F(MatrixFileTest, TakesRowsFromSeveralThreads) {
  const auto s = spec("d.npy", 200, 50);
  MatrixFile matrix = MatrixFile::open(s, false);
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t first = 0; first < 4; ++first)
      threads.emplace_back([&, first] {
        for (std::uint64_t row = first; row < s.rows; row += 4) matrix.write(row, row_values(row, s.columns));
      });
  }
  EXPECT_EQ(matrix.rows_done(), s.rows);
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
}

TEST_F(MatrixFileTest, RefusesToFinishWithoutAllRows) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  matrix.write(0, row_values(0, s.columns));
  EXPECT_THROW(matrix.finish(), std::logic_error);
  EXPECT_FALSE(fs::exists(s.out));
}

TEST_F(MatrixFileTest, RefusesARowOfTheWrongLengthOrPlace) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  EXPECT_THROW(matrix.write(0, std::vector<double>(s.columns - 1)), std::logic_error);
  EXPECT_THROW(matrix.write(s.rows, std::vector<double>(s.columns)), std::logic_error);
}

TEST_F(MatrixFileTest, NoticesARowThatChangesWhileTheRunGoesOn) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  matrix.write(4, row_values(4, s.columns));
  replace_byte(partial_of(s), MatrixFile::bytes(s) - 1);
  EXPECT_THROW(matrix.read(4), InputError);
}

TEST_F(MatrixFileTest, IsWrittenByOneRunAtATime) {
  const auto s = spec("d.npy");
  const MatrixFile first = MatrixFile::open(s, false);
  EXPECT_NE(error_of([&] { MatrixFile::open(s, false); }).find("d.npy.partial is being written by another run"),
            std::string::npos);
}

TEST_F(MatrixFileTest, IsLockedWhereThereAreLocks) { EXPECT_TRUE(MatrixFile::open(spec("d.npy"), false).is_locked()); }

TEST_F(MatrixFileTest, DoesNotPublishAFileThatTookThePlaceOfItsOwn) {
  const auto s = spec("d.npy");
  MatrixFile matrix = MatrixFile::open(s, false);
  write_missing(matrix, s);
  fs::rename(partial_of(s), folder_ / "moved");
  std::ofstream(partial_of(s)) << "somebody else's";
  const std::string error = error_of([&] { matrix.finish(); });
  EXPECT_NE(error.find("was removed or replaced"), std::string::npos) << error;
  EXPECT_FALSE(fs::exists(s.out));
}

TEST_F(MatrixFileTest, RefusesWhatTheDiskCannotHoldAndLeavesNothing) {
  const std::uint64_t too_many = fs::space(folder_.path()).available / 8 / 1000 + 1000000;
  const std::string error = error_of([&] { MatrixFile::open(spec("d.npy", too_many, 1000), false); });
  EXPECT_NE(error.find("bytes more on disk, of which"), std::string::npos) << error;
  EXPECT_EQ(files(), 0u);
}

TEST_F(MatrixFileTest, RefusesWhatNoFileCanHold) {
  const std::uint64_t many = std::uint64_t{1} << 40;
  EXPECT_THROW(MatrixFile::open(spec("d.npy", many, many), false), RefusedError);
}

TEST_F(MatrixFileTest, ReadsTheEndingWithoutRegardToCase) {
  const auto npy = spec("D.NPY", 2, 3), csv = spec("D.Csv", 2, 3);
  for (const auto& s : {npy, csv}) {
    MatrixFile matrix = MatrixFile::open(s, false);
    write_missing(matrix, s);
    matrix.finish();
  }
  EXPECT_EQ(bytes_in(npy.out), expected_npy(npy));
  EXPECT_EQ(bytes_in(csv.out)[bytes_in(csv.out).size() - 1], '\n');
}

TEST_F(MatrixFileTest, RefusesAnUnknownEnding) { EXPECT_THROW(MatrixFile::open(spec("d.h5"), false), OptionError); }

TEST_F(MatrixFileTest, RefusesALargeCsv) {
  EXPECT_NO_THROW(MatrixFile::open(spec("d.csv", 1000, 1000), false));
  EXPECT_THROW(MatrixFile::open(spec("d.csv", 1001, 1000), false), OptionError);
}

TEST_F(MatrixFileTest, NamesAFolderThatIsNotThere) {
  const std::string error = error_of([&] { MatrixFile::open(spec("no/d.npy"), false); });
  EXPECT_NE(error.find("no/d.npy: No such file or directory"), std::string::npos) << error;
}

/// The system refuses to let files grow beyond `size` while this lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(std::uint64_t size) : old_action_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_);
    rlimit now = old_;
    now.rlim_cur = size;
    ::setrlimit(RLIMIT_FSIZE, &now);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &old_);
    ::signal(SIGXFSZ, old_action_);
  }

 private:
  rlimit old_{};
  sighandler_t old_action_;
};

TEST_F(MatrixFileTest, TellsTheSystemsReasonWhenARowCannotBeWritten) {
  const auto s = spec("d.npy", 5, 1000);
  MatrixFile matrix = MatrixFile::open(s, false);
  const FileSizeLimit limit(MatrixFile::bytes(s) -
                            4000);  // in the middle of the last row: a short write, then an error
  const std::string error = error_of([&] { matrix.write(4, row_values(4, s.columns)); });
  EXPECT_NE(error.find("d.npy.partial: File too large"), std::string::npos) << error;
  EXPECT_FALSE(matrix.has(4));
}

TEST_F(MatrixFileTest, LeavesNothingIfItCannotBeStarted) {
  const FileSizeLimit limit(4096);
  EXPECT_THROW(MatrixFile::open(spec("d.npy", 100, 1000), false), InputError);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace geodrome
