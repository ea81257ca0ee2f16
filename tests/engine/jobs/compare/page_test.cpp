// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/page.hpp"

#include <gtest/gtest.h>

#include "engine/formats/base64.hpp"
#include "geodrome/errors.hpp"
#include "tests/support/program.hpp"

namespace geodrome::testing {
namespace {

class ComparisonPages : public ::testing::Test {
 protected:
  ComparisonPage page(const std::string& text) {
    write_bytes(folder_ / "t.html", text);
    return ComparisonPage(folder_ / "t.html");
  }
  TemporaryFolder folder_;
};

TEST_F(ComparisonPages, HoldTheDataInPlaceOfTheMarker) {
  EXPECT_EQ(page("<a><!--geodrome-comparison--></a>").with(R"({"x":1})"),
            R"(<a><script type="application/json" id="geodrome-comparison">{"x":1}</script></a>)");
}

TEST_F(ComparisonPages, LetNoStringBecomeMarkup) {
  const std::string text = page("<!--geodrome-comparison-->").with(R"(["</script><img>", "<!--"])");
  EXPECT_NE(text.find(R"(["\u003c/script>\u003cimg>", "\u003c!--"])"), std::string::npos) << text;
}

TEST_F(ComparisonPages, WithoutTemplateTellHowToGetOne) {
  try {
    ComparisonPage(folder_ / "none.html");
    ADD_FAILURE() << "was taken";
  } catch (const CapabilityError& error) {
    EXPECT_NE(std::string(error.what()).find("none.html"), std::string::npos) << error.what();
    EXPECT_NE(error.remedy().find("nodejs and npm"), std::string::npos);
  }
}

TEST_F(ComparisonPages, NeedExactlyOneMarker) {
  EXPECT_THROW(page("<html></html>"), CapabilityError);
  EXPECT_THROW(page("<!--geodrome-comparison--><!--geodrome-comparison-->"), CapabilityError);
}

TEST(Base64, IsThatOfRfc4648) {
  const auto encoded = [](std::string_view text) { return base64_of(std::span<const char>(text)); };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, OfNumbersIsLittleEndian) {
  const float one = 1;  // 00 00 80 3f
  EXPECT_EQ(base64_of(std::span<const float>(&one, 1)), "AACAPw==");
}

}  // namespace
}  // namespace geodrome::testing
