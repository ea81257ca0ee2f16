// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <new>

#include "geodrome/engine/jobs.hpp"

namespace geodrome {
namespace {

TEST(ExitStatusOfErrors, NamesWhatTheMachineLacks) {
  EXPECT_EQ(exit_status(std::bad_alloc()), 4);
  EXPECT_EQ(exit_status(std::filesystem::filesystem_error("rename", std::make_error_code(std::errc::io_error))), 3);
  EXPECT_EQ(exit_status(std::runtime_error("a fault of the program")), 1);
}

TEST(ExitStatusOfErrors, TellsClassesApart) {
  EXPECT_EQ(exit_status(OptionError("no such option")), 2);
  EXPECT_EQ(exit_status(InputError(InputFault::io, "unreadable")), 3);
  EXPECT_EQ(exit_status(RefusedError("too large")), 4);
  EXPECT_EQ(exit_status(PluginError("failed")), 5);
  EXPECT_EQ(exit_status(Cancelled()), 130);
}

}  // namespace
}  // namespace geodrome
