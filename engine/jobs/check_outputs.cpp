// SPDX-License-Identifier: MIT
#include "engine/jobs/check_outputs.hpp"

#include <unistd.h>

#include "engine/formats/table.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

namespace fs = std::filesystem;

namespace {

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why, const std::string& remedy) {
  throw InputError(InputFault::io, file.string() + ": cannot be written: " + why, remedy);
}

void check_place(const fs::path& file) {
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) refuse(file, "there is no folder " + folder.string(), "make it first");
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::none) refuse(file, error.message(), "choose another name");
  if (fs::is_directory(status)) refuse(file, "is a directory", "name a file inside it");
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(file, "is no regular file", "choose another name");
  // What is written gets its name by renaming, so the folder counts, not the file that may be there.
  if (::access(folder.c_str(), W_OK) != 0)
    refuse(file, "the folder " + folder.string() + " may not be written", "choose another one");
}

}  // namespace

std::vector<fs::path> files_read(const fs::path& input, const ReadOptions& options,
                                 std::span<const std::string> selections) {
  std::vector<fs::path> files{input};
  if (fs::path weights = weights_file(options); !weights.empty()) files.push_back(std::move(weights));
  for (const std::string& selection : selections)
    if (selection.starts_with('@') && selection.size() > 1) files.emplace_back(selection.substr(1));
  return files;
}

void check_ending(const fs::path& file, Content content) {
  if (!file.empty()) format_to_write(file, content);
}

void check_mesh_ending(const fs::path& file, const ReadOptions& options) {
  if (!file.empty()) mesh_format_to_write(file, !options.weights.empty());
}

void check_outputs(std::span<const fs::path> outputs, std::span<const fs::path> read) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const fs::path& file = outputs[i];
    if (file.empty()) continue;
    check_place(file);
    for (const fs::path& other : read)
      if (is_same_file(file, other))
        throw OptionError(file.string() + " would be written over a file that is read", "choose another name");
    for (const fs::path& other : outputs.first(i))
      if (!other.empty() && is_same_file(file, other))
        throw OptionError(file.string() + " is named for two outputs", "choose different names");
  }
}

}  // namespace geodrome
