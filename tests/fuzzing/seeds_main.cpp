// SPDX-License-Identifier: MIT
// fuzz_seeds FOLDER [FILES]: writes the seeds of every target into FOLDER/TARGET. With FILES, a folder of broken meshes
// and points, each of its files becomes a seed of the target of its ending, and of `any`.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "engine/formats/ending.hpp"
#include "tests/fuzzing/target.hpp"

namespace {

namespace fs = std::filesystem;
using namespace geodrome;

void write(const fs::path& file, const std::string& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

void write_file_as_seeds(const fs::path& folder, const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  for (const fuzzing::Target& target : fuzzing::targets())
    if (target.name == "any" || has_ending(file, "." + std::string(target.name)))
      write(folder / target.name / file.filename(), std::string(1, '\0') + bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: fuzz_seeds FOLDER [FILES]\n";
    return 2;
  }
  const fs::path folder = argv[1];
  for (const fuzzing::Target& target : fuzzing::targets()) {
    const std::vector<std::string> seeds = target.seeds();
    for (std::size_t i = 0; i < seeds.size(); ++i) write(folder / target.name / ("seed" + std::to_string(i)), seeds[i]);
  }
  if (argc == 3)
    for (const fs::directory_entry& entry : fs::directory_iterator(argv[2]))
      if (entry.is_regular_file()) write_file_as_seeds(folder, entry.path());
}
