// SPDX-License-Identifier: MIT
// The promises of the readers on the seeds, on mutations of them that are the same on every run, and on all that
// libFuzzer found.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fuzzing/found.hpp"
#include "tests/fuzzing/mutation.hpp"
#include "tests/fuzzing/target.hpp"
#include "tests/support/program.hpp"

namespace geodrome::fuzzing {

void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

class Reader : public ::testing::TestWithParam<Target> {
 protected:
  static void expect_kept(const std::string& input, const std::string& what) {
    try {
      GetParam().check(input);
    } catch (const std::exception& broken) {
      ADD_FAILURE() << GetParam().name << ", " << what << ": " << broken.what() << "\n"
                    << ::testing::PrintToString(input.substr(0, 2000));
    }
  }
};

TEST_P(Reader, KeepsItsPromisesOnSeeds) {
  const std::vector<std::string> seeds = GetParam().seeds();
  EXPECT_GT(seeds.size(), 1u);
  for (std::size_t i = 0; i < seeds.size(); ++i) expect_kept(seeds[i], "seed " + std::to_string(i));
}

TEST_P(Reader, KeepsItsPromisesOnEverySeedCutAnywhere) {
  for (const std::string& seed : GetParam().seeds())
    for (std::size_t size = 0; size < std::min<std::size_t>(seed.size(), 300); ++size)
      expect_kept(seed.substr(0, size), "cut to " + std::to_string(size));
}

TEST_P(Reader, KeepsItsPromisesOnMutations) {
  constexpr int rounds = 3000;
  std::mt19937_64 random(20260101);
  const std::vector<std::string> seeds = GetParam().seeds();
  for (int round = 0; round < rounds; ++round)
    expect_kept(mutated(seeds[static_cast<std::size_t>(random() % seeds.size())], random),
                "round " + std::to_string(round));
}

TEST_P(Reader, KeepsItsPromisesOnLongInputs) {
  std::mt19937_64 random(3);
  for (const std::string& seed : GetParam().seeds())
    for (int round = 0; round < 3; ++round)
      expect_kept(stretched(seed, random), "stretched, round " + std::to_string(round));
}

TEST_P(Reader, KeepsItsPromisesOnWhatWasFound) {
  for (const Found& found : found_inputs())
    if (found.target == GetParam().name) expect_kept(std::string(found.input), std::string(found.what));
}

/// Broken files that live beside the checkout, as any kind of input that a mesh or points may come in.
TEST_P(Reader, KeepsItsPromisesOnBrokenFiles) {
  const std::filesystem::path folder = std::filesystem::path(GEODROME_SHARED_DATA) / "bad";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << folder << " is not there";
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file())
      for (const char choices : {'\0', '\x15', '\x31', '\x2B', '\xF4'})
        expect_kept(choices + geodrome::testing::read_bytes(entry.path()), entry.path().filename().string());
}

INSTANTIATE_TEST_SUITE_P(Targets, Reader, ::testing::ValuesIn(targets().begin(), targets().end()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace geodrome::fuzzing
