// SPDX-License-Identifier: MIT
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/engine/output/matrix_file_fixture.hpp"

namespace geodrome {
namespace {

class MatrixFileResumeTest : public MatrixFileTest {};

TEST_F(MatrixFileResumeTest, ResumesWithTheRowsThatAreThere) {
  const auto s = spec("d.npy");
  begin(s, 3);
  MatrixFile matrix = MatrixFile::open(s, true);
  EXPECT_EQ(matrix.rows_done(), 3u);
  EXPECT_TRUE(matrix.has(2));
  EXPECT_FALSE(matrix.has(3));
}

TEST_F(MatrixFileResumeTest, StartsAnewWithoutResume) {
  const auto s = spec("d.npy");
  begin(s, 3);
  EXPECT_EQ(MatrixFile::open(s, false).rows_done(), 0u);
}

TEST_F(MatrixFileResumeTest, StartsAnewIfThereIsNothingToResume) {
  EXPECT_EQ(MatrixFile::open(spec("d.npy"), true).rows_done(), 0u);
}

TEST_F(MatrixFileResumeTest, ComputesRowsAgainThatWereDamagedOnDisk) {
  const auto s = spec("d.npy");
  begin(s, 5);
  replace_byte(partial_of(s), MatrixFile::bytes(s) - 8 * 7 * 3 - 1);  // the last byte of row 1
  MatrixFile matrix = MatrixFile::open(s, true);
  EXPECT_EQ(matrix.rows_done(), 4u);
  EXPECT_FALSE(matrix.has(1));
  write_missing(matrix, s);
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
}

TEST_F(MatrixFileResumeTest, RefusesToResumeADamagedFooter) {
  const auto s = spec("d.npy");
  begin(s, 2);
  replace_byte(partial_of(s), fs::file_size(partial_of(s)) - 40);
  EXPECT_THROW(MatrixFile::open(s, true), RefusedError);
}

TEST_F(MatrixFileResumeTest, RefusesToResumeATruncatedPartial) {
  const auto s = spec("d.npy");
  begin(s, 2);
  fs::resize_file(partial_of(s), fs::file_size(partial_of(s)) / 2);
  EXPECT_THROW(MatrixFile::open(s, true), RefusedError);
}

TEST_F(MatrixFileResumeTest, RefusesToResumeAFileOfAnotherKind) {
  const auto s = spec("d.npy");
  std::ofstream(partial_of(s)) << std::string(1000, 'x');
  EXPECT_THROW(MatrixFile::open(s, true), RefusedError);
  EXPECT_EQ(bytes_in(partial_of(s)), std::string(1000, 'x'));
}

TEST_F(MatrixFileResumeTest, StartsAnewIfTheFirstRunDiedBeforeItsFirstRow) {
  const auto s = spec("d.npy");
  std::ofstream(partial_of(s)).close();
  fs::resize_file(partial_of(s), 5000);
  EXPECT_EQ(MatrixFile::open(s, true).rows_done(), 0u);
}

/// Leaves what a run leaves that ends in `finish` after it has cut the footer off: here because the name is taken by a
/// folder.
class MatrixFileWithoutNameTest : public MatrixFileTest {
 protected:
  void leave_without_name(const MatrixFile::Spec& s) {
    MatrixFile matrix = MatrixFile::open(s, false);
    write_missing(matrix, s);
    fs::create_directory(s.out);
    EXPECT_THROW(matrix.finish(), InputError);
    fs::remove(s.out);
    ASSERT_EQ(bytes_in(partial_of(s)), expected_npy(s));
  }
  static fs::path footer_of(const MatrixFile::Spec& s) { return s.out.string() + ".partial-footer"; }
};

TEST_F(MatrixFileWithoutNameTest, GoesOnWithEveryRowAndLeavesTheMatrixAlone) {
  const auto s = spec("d.npy");
  leave_without_name(s);
  MatrixFile matrix = MatrixFile::open(s, true);
  EXPECT_EQ(matrix.rows_done(), s.rows);
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
  EXPECT_EQ(files(), 1u);
}

TEST_F(MatrixFileWithoutNameTest, GoesOnIfTheFooterWasPutBackInPart) {
  const auto s = spec("d.npy");
  leave_without_name(s);
  const auto footer = bytes_in(footer_of(s));
  for (std::size_t part = 0; part < footer.size(); part += 9) {
    std::ofstream(partial_of(s), std::ios::binary) << expected_npy(s) << footer.substr(0, part);
    std::ofstream(footer_of(s), std::ios::binary) << footer;
    EXPECT_EQ(MatrixFile::open(s, true).rows_done(), s.rows) << part << " bytes";
  }
}

TEST_F(MatrixFileWithoutNameTest, GoesOnIfTheFooterWasSavedInPart) {
  const auto s = spec("d.npy");
  begin(s, 5);
  std::ofstream(footer_of(s), std::ios::binary) << "half";
  EXPECT_EQ(MatrixFile::open(s, true).rows_done(), s.rows);
}

TEST_F(MatrixFileWithoutNameTest, StillSaysInWhichMembersTheFingerprintsDiffer) {
  auto s = spec("d.npy");
  leave_without_name(s);
  s.fingerprint = "{}";
  EXPECT_NE(error_of([&] { MatrixFile::open(s, true); }).find("/seed was 1 and is absent"), std::string::npos);
}

TEST_F(MatrixFileWithoutNameTest, TrustsNoRowOfAnotherMatrixOfTheSameSize) {
  const auto s = spec("d.npy");
  leave_without_name(s);
  auto other = bytes_in(partial_of(s));
  std::fill(other.begin() + static_cast<std::ptrdiff_t>(other.size() - s.rows * s.columns * 8), other.end(), '\x3f');
  std::ofstream(partial_of(s), std::ios::binary) << other;
  EXPECT_EQ(MatrixFile::open(s, true).rows_done(), 0u);
}

TEST_F(MatrixFileWithoutNameTest, LeavesRowsAloneWhereTheSavedFooterIsOfFewer) {
  auto fewer = spec("d.npy");
  fewer.rows = 1;
  leave_without_name(fewer);
  const auto footer = bytes_in(footer_of(fewer));
  const auto s = spec("d.npy");
  const std::string whole = expected_npy(s);
  for (std::size_t size = expected_npy(fewer).size(); size <= whole.size(); size += 8) {
    std::ofstream(partial_of(s), std::ios::binary) << whole.substr(0, size);
    std::ofstream(footer_of(s), std::ios::binary) << footer;
    error_of([&] { MatrixFile::open(s, true); });
    EXPECT_EQ(bytes_in(partial_of(s)), whole.substr(0, size)) << size;
  }
}

TEST_F(MatrixFileWithoutNameTest, ForgetsTheSavedFooterWhenItStartsAnew) {
  const auto s = spec("d.npy");
  leave_without_name(s);
  EXPECT_EQ(MatrixFile::open(s, false).rows_done(), 0u);
  EXPECT_FALSE(fs::exists(footer_of(s)));
}

TEST_F(MatrixFileWithoutNameTest, RefusesAMatrixWhoseFooterIsLost) {
  const auto s = spec("d.npy");
  std::ofstream(partial_of(s), std::ios::binary) << expected_npy(s);
  EXPECT_NE(error_of([&] { MatrixFile::open(s, true); }).find("rename it to"), std::string::npos);
  EXPECT_EQ(bytes_in(partial_of(s)), expected_npy(s));
}

TEST_F(MatrixFileResumeTest, SaysInWhichMembersTheFingerprintsDiffer) {
  auto s = spec("d.npy");
  begin(s, 2);
  s.fingerprint = R"({"input": "abc", "seed": 2, "solver": {"name": "exact"}})";
  const std::string error = error_of([&] { MatrixFile::open(s, true); });
  EXPECT_NE(error.find("/seed was 1 and is 2"), std::string::npos) << error;
  EXPECT_NE(error.find("/solver/delta was 0.5 and is absent"), std::string::npos) << error;
  EXPECT_EQ(error.find("input"), std::string::npos) << error;
}

TEST_F(MatrixFileResumeTest, ShortensLongValuesOfTheFingerprint) {
  auto s = spec("d.npy");
  begin(s, 2);
  s.fingerprint = R"({"input": ")" + std::string(500, 'x') + "\"}";
  EXPECT_LT(error_of([&] { MatrixFile::open(s, true); }).size(), 500u);
}

TEST_F(MatrixFileResumeTest, ShowsADifferentFingerprintInOneShortLineWhateverIsInIt) {
  std::string many = "{";
  for (int i = 0; i < 500; ++i) many += '"' + std::to_string(i) + "\":1,";
  const std::string deep(100'000, '[');
  for (const std::string& fingerprint : {many + "\"\u001b\":2}", std::string("\x1B[2J\n"), "{\"a\":" + deep,
                                         "{\"a\":" + deep + std::string(deep.size(), ']') + "}"}) {
    auto s = spec("d.npy");
    s.fingerprint = fingerprint;
    begin(s, 2);
    s.fingerprint = spec("d.npy").fingerprint;
    const std::string error = error_of([&] { MatrixFile::open(s, true); });
    EXPECT_NE(error.find("was started by a different run"), std::string::npos) << error;
    EXPECT_LT(error.size(), 1500u);
    EXPECT_EQ(error.find_first_of("\x1B\n"), std::string::npos) << error;
  }
}

TEST_F(MatrixFileResumeTest, SaysThatTheShapeDiffers) {
  begin(spec("d.npy", 5, 7), 2);
  const std::string error = error_of([&] { MatrixFile::open(spec("d.npy", 6, 7), true); });
  EXPECT_NE(error.find("the number of rows was 5 and is 6"), std::string::npos) << error;
}

TEST_F(MatrixFileResumeTest, TakesAFingerprintOfAnotherSpellingAsTheSame) {
  auto s = spec("d.npy");
  begin(s, 2);
  s.fingerprint = R"({"seed":1,"solver":{"delta":0.5,"name":"exact"},"input":"abc"})";
  EXPECT_EQ(MatrixFile::open(s, true).rows_done(), 2u);
}

TEST_F(MatrixFileResumeTest, LeavesThePartialAloneWhenItRefuses) {
  auto s = spec("d.npy");
  begin(s, 2);
  const std::string before = bytes_in(partial_of(s));
  s.fingerprint = "{}";
  EXPECT_THROW(MatrixFile::open(s, true), RefusedError);
  EXPECT_EQ(bytes_in(partial_of(s)), before);
}

TEST_F(MatrixFileResumeTest, SurvivesKillsAtAnyMomentWithTheSameBytes) {
  const auto s = spec("d.npy", 600, 301);
  std::mt19937_64 random(17);
  std::uint64_t done = 0;
  for (int kill = 0; kill < 6; ++kill) {
    const pid_t child = ::fork();
    ASSERT_NE(child, -1);
    if (child == 0) {
      MatrixFile matrix = MatrixFile::open(s, true);
      for (std::uint64_t row = 0; row < s.rows; ++row) {
        if (!matrix.has(row)) matrix.write(row, row_values(row, s.columns));
        ::usleep(1000);  // at least 600 ms in all: no child comes to its end
      }
      ::_exit(0);
    }
    ::usleep(static_cast<useconds_t>(kill == 0 ? 500 : random() % 80'000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    done = std::max(done, MatrixFile::open(s, true).rows_done());
  }
  EXPECT_GT(done, 0u);
  MatrixFile matrix = MatrixFile::open(s, true);
  EXPECT_EQ(matrix.rows_done(), done);
  write_missing(matrix, s);
  matrix.finish();
  EXPECT_EQ(bytes_in(s.out), expected_npy(s));
}

}  // namespace
}  // namespace geodrome
