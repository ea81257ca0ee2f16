// SPDX-License-Identifier: MIT
// Every plugin of the build against every demand of the conformance kit on its stage, one test each; merged windows
// without exact ones as well, which small meshes get.
#include <filesystem>
#include <set>

#include "geodrome/conformance/gtest.hpp"

namespace {

namespace fs = std::filesystem;
using geodrome::conformance::Subject;

/// Named by its file alone: the tests are listed without a plugin being loaded.
Subject subject_of(const fs::path& file) {
  const std::string name = file.stem().string();
  Subject subject;
  subject.plugin.file = file;
  subject.plugin.stage = name.substr(0, name.find('_'));
  subject.plugin.name = name.substr(name.find('_') + 1);
  return subject;
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(GEODROME_BINARY_DIR "/lib/geodrome"))
    if (entry.path().extension() == ".so") files.insert(entry.path());
  const fs::path alone = GEODROME_BINARY_DIR "/tests/sound_plugins/solver_test_merged_alone.so";
  if (fs::exists(alone)) files.insert(alone);
  for (const fs::path& file : files) geodrome::conformance::register_tests(subject_of(file));
  return RUN_ALL_TESTS();
}
