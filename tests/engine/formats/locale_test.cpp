// SPDX-License-Identifier: MIT
// A program that uses the engine may have set a locale whose numbers look otherwise.
#include <gtest/gtest.h>

#include <cmath>
#include <locale>

#include "engine/formats/number_text.hpp"
#include "engine/formats/text_stream.hpp"

namespace geodrome {
namespace {

struct German : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class ProgramWithALocale : public ::testing::Test {
 protected:
  ~ProgramWithALocale() override { std::locale::global(before_); }

 private:
  std::locale before_ = std::locale::global(std::locale(std::locale::classic(), new German));
};

TEST_F(ProgramWithALocale, GetsTextWithDecimalPointsAlone) {
  std::ostringstream own;
  own << 12345.5;
  ASSERT_EQ(own.str(), "12.345,5") << "the locale is not in force";
  TextOutput text;
  text << 12345 << " " << 0.25;
  EXPECT_EQ(text.str(), "12345 0.25");
}

TEST_F(ProgramWithALocale, HasNumbersReadAsTheyAreWritten) {
  TextInput text("12345 0.25");
  int whole = 0;
  double part = 0;
  text >> whole >> part;
  EXPECT_EQ(whole, 12345);
  EXPECT_EQ(part, 0.25);
}

TEST(RoundedText, HasTheDigitsThatAreAskedFor) {
  EXPECT_EQ(rounded_text(2.0 / 3, 3), "0.667");
  EXPECT_EQ(rounded_text(50, 3), "50");
  EXPECT_EQ(rounded_text(1234567, 3), "1.23e+06");
  EXPECT_EQ(rounded_text(HUGE_VAL, 3), "inf");
}

}  // namespace
}  // namespace geodrome
