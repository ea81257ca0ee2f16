// SPDX-License-Identifier: MIT
// Compressed files. The first byte: 1 packs the rest, in pieces, and holds what is unpacked against it; else the rest
// is what stands behind the first bytes of gzip.
#include "engine/formats/gzip.hpp"

#include <algorithm>

#include "engine/formats/bytes.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

using input::SourceFile;

constexpr std::size_t most_unpacked = 1 << 20;

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t sum = ~0u;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xEDB88320u : 0);
  }
  return ~sum;
}

/// A member that holds bytes as they are. Source: RFC 1951 and 1952.
std::string member(std::string_view bytes) {
  std::string packed("\x1F\x8B\x08\0\0\0\0\0\0\xFF\x01", 11);
  const auto length = static_cast<std::uint16_t>(bytes.size());
  append_little_endian(packed, length), append_little_endian(packed, static_cast<std::uint16_t>(~length));
  packed += bytes;
  append_little_endian(packed, crc32(bytes)), append_little_endian(packed, static_cast<std::uint32_t>(bytes.size()));
  return packed;
}

/// In members of up to 100 bytes, and zeros behind the last.
std::string packed(std::string_view bytes) {
  std::string all;
  for (; !bytes.empty(); bytes.remove_prefix(std::min<std::size_t>(100, bytes.size())))
    all += member(bytes.substr(0, 100));
  return all + std::string(3, '\0');
}

std::string unpacked(std::string bytes) {
  SourceFile file{"m.ply.gz", std::move(bytes)};
  input::unpack_gzip(file, most_unpacked);
  return file.bytes;
}

}  // namespace

void check_gzip(std::string_view input) {
  const std::string_view rest = rest_of(input);
  if (Choices(input).bit(0)) {
    if (!rest.empty()) demand(unpacked(packed(rest)) == rest, "what was packed is unpacked");
    return;
  }
  const std::string bytes = "\x1F\x8B" + std::string(rest);
  const auto content = read_or_refusal("m.ply.gz", bytes, [&] { return unpacked(bytes); });
  if (content) demand(!content->empty() && content->size() <= most_unpacked, "what is unpacked is within the limit");
}

std::vector<std::string> gzip_seeds() {
  // "aaaaaaaaaa" by the fixed codes of deflate.
  const std::string fixed("\x08\0\0\0\0\0\2\3\x4B\x4C\x84\1\0\xF0\xCD\x11\x4C\x0A\0\0\0", 21);
  return {std::string(1, '\1') + "ply\n" + std::string(150, 'x'), std::string(1, '\0') + fixed,
          std::string(1, '\0') + member("OFF\n").substr(2),
          std::string(1, '\0') + packed(std::string(120, 'y')).substr(2)};
}

}  // namespace geodrome::fuzzing
