// SPDX-License-Identifier: MIT
#include "engine/formats/source_file.hpp"

#include <xxhash.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include "engine/formats/gzip.hpp"

namespace geodrome::input {
namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string last_reason() { return std::generic_category().message(errno); }

}  // namespace

void reject(const SourceFile& file, InputFault fault, const std::string& what, Remedy remedy) {
  throw InputError(fault, file.path.string() + ": " + what, std::move(remedy));
}

SourceFile read_source(const std::filesystem::path& path) {
  SourceFile file{path, {}, false};
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) reject(file, InputFault::io, "there is no such file", "check the path");
  if (std::filesystem::is_directory(status)) reject(file, InputFault::io, "is a directory", "give a file inside it");
  // Devices such as /dev/zero never end.
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    reject(file, InputFault::io, "is no regular file");

  const std::unique_ptr<std::FILE, Closer> stream(std::fopen(path.c_str(), "rb"));
  if (!stream) reject(file, InputFault::io, "cannot be opened: " + last_reason(), "check its permissions");
  const auto size = std::filesystem::file_size(path, ignored);
  if (std::filesystem::is_regular_file(status) && !ignored) file.bytes.reserve(size);
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, stream.get())) file.bytes.append(block, count);
  if (std::ferror(stream.get())) reject(file, InputFault::io, "cannot be read: " + last_reason());
  if (file.bytes.empty()) reject(file, InputFault::empty, "the file has 0 bytes");
  if (is_gzip(file.bytes)) unpack_gzip(file);
  return file;
}

std::string content_hash(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : canonical.digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

}  // namespace geodrome::input
