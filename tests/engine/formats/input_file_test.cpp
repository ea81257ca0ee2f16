// SPDX-License-Identifier: MIT
#include "engine/formats/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <new>
#include <streambuf>
#include <thread>

#include "engine/formats/source_file.hpp"
#include "engine/formats/text_stream.hpp"
#include "tests/support/input_files.hpp"
#include "tests/support/program.hpp"

namespace geodrome::input {
namespace {

namespace fs = std::filesystem;
using testing::expect_refused;

/// A file that was written some time before it is opened, so that every later change shows.
class OpenFile : public ::testing::Test {
 protected:
  OpenFile() {
    testing::write_bytes(path_, content_);
    fs::last_write_time(path_, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }

  testing::TemporaryFolder folder_;
  const fs::path path_ = folder_ / "f.xyz";
  const std::string content_ = "0 0 0\n1 0 0\n0 1 0\n";
};

TEST_F(OpenFile, IsReadWhole) {
  InputFile file(path_);
  std::string bytes(100, '\0');
  bytes.resize(file.read(bytes.data(), bytes.size()));
  EXPECT_EQ(bytes, content_);
  EXPECT_EQ(file.size(), content_.size());
  EXPECT_EQ(file.read(bytes.data(), bytes.size()), 0u);
  EXPECT_NO_THROW(file.demand_unchanged());
}

TEST_F(OpenFile, ThatIsReplacedStaysAsItWas) {
  const InputFile file(path_);
  testing::write_bytes(folder_ / "new", "other");
  fs::rename(folder_ / "new", path_);
  std::string bytes(content_.size(), '\0');
  file.read_at(0, bytes.data(), bytes.size());
  EXPECT_EQ(bytes, content_);
  EXPECT_NO_THROW(file.demand_unchanged());
}

TEST_F(OpenFile, ThatIsWrittenToIsFoundOut) {
  for (const std::string& now : {std::string("0 0 0\n"), content_ + "2 2 2\n", "9" + content_.substr(1)}) {
    testing::write_bytes(path_, content_);
    fs::last_write_time(path_, fs::file_time_type::clock::now() - std::chrono::hours(1));
    const InputFile file(path_);
    testing::write_bytes(path_, now);
    expect_refused([&] { file.demand_unchanged(); }, InputFault::io, "was changed while it was read");
  }
}

TEST_F(OpenFile, ThatEndsTooEarlyIsToldAsChanged) {
  const InputFile file(path_);
  fs::resize_file(path_, 3);
  std::string bytes(content_.size(), '\0');
  expect_refused([&] { file.read_at(0, bytes.data(), bytes.size()); }, InputFault::io, "was changed");
}

TEST_F(OpenFile, MayBeAPipe) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::jthread writer([&] { testing::write_bytes(pipe, content_); });
  EXPECT_EQ(read_source(pipe).bytes, content_);
}

TEST_F(OpenFile, IsNoFolderAndNoDevice) {
  expect_refused([&] { InputFile(folder_.path()); }, InputFault::io, "is a directory");
  expect_refused([] { InputFile("/dev/zero"); }, InputFault::io, "is no regular file");
  expect_refused([&] { InputFile(folder_ / "none"); }, InputFault::io, "there is no such file");
  expect_refused([&] { InputFile(path_ / "inside"); }, InputFault::io, "there is no such file");
}

/// Characters that memory does not suffice for.
class NoMemory : public std::streambuf {
  int_type overflow(int_type) override { throw std::bad_alloc(); }
  int_type underflow() override { throw std::bad_alloc(); }
};

TEST(TextStreams, ThrowWhereMemoryRunsOut) {
  NoMemory none;
  TextOutput out;
  static_cast<std::ostream&>(out).rdbuf(&none);
  EXPECT_THROW(out << "text", std::bad_alloc);
  TextInput in("");
  static_cast<std::istream&>(in).rdbuf(&none);
  std::string word;
  EXPECT_THROW(in >> word, std::bad_alloc);
}

TEST(TextStreams, BeginWhereTheyAreTold) {
  TextInput in("abc def", 4);
  std::string word;
  in >> word;
  EXPECT_EQ(word, "def");
}

}  // namespace
}  // namespace geodrome::input
