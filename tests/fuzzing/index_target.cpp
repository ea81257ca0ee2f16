// SPDX-License-Identifier: MIT
// Files of pair oracles, up to what the plugin saved. The first byte: 1, 2, 4 put right the checksums of the first
// bytes, of the identity and of the payload, which no mutation hits; 8 their lengths too.
#include <xxhash.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "engine/output/index_file.hpp"
#include "tests/fuzzing/memory_file.hpp"
#include "tests/fuzzing/target.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::fuzzing {
namespace {

IndexIdentity index_identity() {
  return {"solver_some", {{"delta", "0.1"}, {"mode", "on"}}, 7, 8, 12, "0123456789abcdef0123456789abcdef"};
}

// The layout as index_file.hpp states it.
constexpr std::size_t preamble_bytes = 64, identity_length = 16, identity_sum = 24, payload_length = 32,
                      payload_sum = 40, own_sum = 56;

std::uint64_t number_in(const std::string& bytes, std::size_t at) {
  std::uint64_t number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

void put_in(std::string& bytes, std::size_t at, std::uint64_t number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

/// What stands behind the identity, as a mutation leaves it, is the payload.
void put_right_index(std::string& bytes, const Choices& choices) {
  if (bytes.size() < preamble_bytes) return;
  const std::size_t behind = bytes.size() - preamble_bytes;
  if (choices.bit(3)) {
    const std::size_t closing = bytes.find('}', preamble_bytes + 90);
    const std::size_t length = closing == bytes.npos ? behind : closing + 1 - preamble_bytes;
    put_in(bytes, identity_length, length), put_in(bytes, payload_length, behind - length);
  }
  const std::uint64_t length = std::min<std::uint64_t>(number_in(bytes, identity_length), behind);
  const char* const identity = bytes.data() + preamble_bytes;
  if (choices.bit(1)) put_in(bytes, identity_sum, XXH3_64bits(identity, length));
  if (choices.bit(2)) put_in(bytes, payload_sum, XXH3_64bits(identity + length, behind - length));
  if (choices.bit(0)) put_in(bytes, own_sum, XXH3_64bits(bytes.data(), own_sum));
}

}  // namespace

void check_index(std::string_view input) {
  static const MemoryFile file;
  std::string bytes(rest_of(input));
  put_right_index(bytes, Choices(input));
  file.hold(bytes);
  const auto payload = read_or_refusal(file.path(), bytes, [&] {
    TextInput stream = open_index(file.path(), index_identity());
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  });
  if (!payload) return;
  demand(payload->size() == number_in(bytes, payload_length), "the payload has its length");
  demand(bytes.ends_with(*payload), "the payload is the end of the file");
}

std::vector<std::string> index_seeds() {
  const geodrome::testing::TemporaryFolder folder;
  std::vector<std::string> seeds;
  const auto add = [&](const std::string& payload) {
    write_index(folder / "i", index_identity(), [&](std::ostream& out) { out << payload; });
    std::ifstream stream(folder / "i", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    for (const char choices : {'\0', '\7', '\xF'}) seeds.push_back(choices + bytes);
  };
  add("");
  add(std::string("payload\0 with zeros", 19));
  return seeds;
}

}  // namespace geodrome::fuzzing
