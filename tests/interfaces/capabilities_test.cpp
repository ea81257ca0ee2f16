// SPDX-License-Identifier: MIT
#include "geodrome/capabilities.hpp"

#include <gtest/gtest.h>

namespace geodrome {
namespace {

TEST(Capabilities, ASetHasItsBitsAndAllOfThemTogether) {
  const Provides set = Provides::paths | Provides::any_point;
  EXPECT_TRUE(has(set, Provides::paths));
  EXPECT_TRUE(has(set, Provides::paths | Provides::any_point));
  EXPECT_FALSE(has(set, Provides::paths | Provides::weights));
  EXPECT_TRUE(has(set, Provides::nothing));
}

TEST(Capabilities, WordsComeInTheOrderOfTheBits) {
  EXPECT_EQ(words_of(Provides::weights | Provides::start_distances),
            (std::vector<std::string>{"start_distances", "weights"}));
  EXPECT_EQ(words_of(Needs::closed | Needs::manifold), (std::vector<std::string>{"manifold", "closed"}));
  EXPECT_TRUE(words_of(Needs::nothing).empty());
}

TEST(Capabilities, EveryKnownBitHasOneWord) {
  std::uint64_t bit = 1;
  for (const auto& known : provides_words) {
    EXPECT_EQ(static_cast<std::uint64_t>(known.bit), bit) << known.word;
    bit *= 2;
  }
  EXPECT_EQ(unknown_bits(Provides{bit}), Provides{bit}) << "the bit behind the last one";
}

TEST(Capabilities, BitsOfALaterVersionAreTold) {
  const Needs later{std::uint64_t{1} << 40};
  EXPECT_EQ(unknown_bits(later | Needs::closed), later);
  EXPECT_EQ(unknown_bits(Needs::closed | Needs::oriented | Needs::manifold), Needs::nothing);
}

}  // namespace
}  // namespace geodrome
