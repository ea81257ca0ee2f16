// SPDX-License-Identifier: MIT
#include "engine/formats/base64.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace geodrome {
namespace {

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text) << bytes;
}

TEST(Base64, UsesEveryDigitOfTheAlphabetInOrder) {
  std::string bytes;  // the numbers 0 .. 63, six bits each
  for (std::uint32_t i = 0; i < 64; i += 4) {
    const std::uint32_t bits = i << 18 | (i + 1) << 12 | (i + 2) << 6 | (i + 3);
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(bits >> shift & 0xff);
  }
  EXPECT_EQ(base64(bytes), "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/");
}

TEST(Base64, TakesBytesThatAreNoText) {
  EXPECT_EQ(base64({"\xff\xfe\0", 3}), "//4A");
  EXPECT_EQ(base64({"\x80", 1}), "gA==");
}

TEST(Base64, OfNumbersIsThatOfTheirLittleEndianBytes) {
  const std::uint32_t numbers[] = {1, 0x04030201};
  EXPECT_EQ(base64_of(std::span<const std::uint32_t>(numbers)), base64({"\1\0\0\0\1\2\3\4", 8}));
}

}  // namespace
}  // namespace geodrome
