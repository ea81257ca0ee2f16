// SPDX-License-Identifier: MIT
#include "engine/output/lock_file.hpp"

#include <unistd.h>

#include <optional>

#include "tests/engine/output/matrix_file_fixture.hpp"

namespace geodrome {
namespace {

TEST(LockFile, KeepsOthersAwayAndNamesItsOwner) {
  const TemporaryFolder folder;
  const fs::path path = folder / "d.npy.partial-lock";
  std::optional<LockFile> lock(std::in_place, path);
  const std::string error = error_of([&] { LockFile second(path); });
  EXPECT_NE(error.find("process " + std::to_string(getpid()) + " on "), std::string::npos) << error;
  EXPECT_NE(error.find("d.npy.partial-lock"), std::string::npos) << error;
  EXPECT_TRUE(fs::exists(path));
  lock.reset();
  EXPECT_FALSE(fs::exists(path));
  EXPECT_NO_THROW(LockFile{path});
}

TEST(LockFile, NamesAFolderThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_NE(error_of([&] { LockFile lock(folder / "no/lock"); }).find("No such file or directory"), std::string::npos);
}

}  // namespace
}  // namespace geodrome
