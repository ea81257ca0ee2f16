// SPDX-License-Identifier: MIT
#include "engine/formats/source_file.hpp"

#include <xxhash.h>

#include <utility>

#include "engine/formats/gzip.hpp"
#include "engine/formats/input_file.hpp"

namespace geodrome::input {
void reject(const SourceFile& file, InputFault fault, const std::string& what, Remedy remedy) {
  throw InputError(fault, file.path.string() + ": " + what, std::move(remedy));
}

SourceFile read_source(const std::filesystem::path& path) {
  SourceFile source{path, {}, false};
  InputFile file(path);
  source.bytes.reserve(file.size());
  char block[1 << 16];
  while (const std::size_t count = file.read(block, sizeof block)) source.bytes.append(block, count);
  file.demand_unchanged();
  if (source.bytes.empty()) reject(source, InputFault::empty, "the file has 0 bytes");
  if (is_gzip(source.bytes)) unpack_gzip(source);
  return source;
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

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result;
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "..." : "");
}

std::string quoted(std::string_view text) { return "'" + printable(text) + "'"; }

}  // namespace geodrome::input
