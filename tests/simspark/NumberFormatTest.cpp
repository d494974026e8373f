#include "simspark/NumberFormat.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace plumbline::simspark {
namespace {

std::string fixed(double value, int decimals = 2) {
  std::string out;
  appendFixed(out, value, decimals);
  return out;
}

std::string general(float value) {
  std::string out;
  appendGeneral(out, value);
  return out;
}

std::string printed(const char* format, double value) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

TEST(NumberFormat, fixed) {
  EXPECT_EQ(fixed(0), "0.00");
  EXPECT_EQ(fixed(-0.0), "-0.00");
  EXPECT_EQ(fixed(-0.001), "-0.00");
  EXPECT_EQ(fixed(1.006), "1.01");
  EXPECT_EQ(fixed(-179.995001), "-180.00");
  EXPECT_EQ(fixed(8276.97), "8276.97");
  EXPECT_EQ(fixed(3.7, 0), "4");
  EXPECT_EQ(fixed(0.0000123, 5), "0.00001");
  EXPECT_EQ(fixed(-1e30), printed("%.2f", -1e30));
  EXPECT_EQ(fixed(std::numeric_limits<double>::infinity()), "inf");
}

TEST(NumberFormat, fixedIsWhatPrintfWrites) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const double value =
        std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), int(random() % 17));
    ASSERT_EQ(fixed(value), printed("%.2f", value));
    ASSERT_EQ(fixed(value, 5), printed("%.5f", value));
  }
}

TEST(NumberFormat, generalIsWhatPrintfWrites) {
  EXPECT_EQ(general(0), "0");
  EXPECT_EQ(general(-0.0f), "-0");
  EXPECT_EQ(general(1), "1");
  EXPECT_EQ(general(-8.74228e-08f), "-8.74228e-08");
  EXPECT_EQ(general(0.0402764f), "0.0402764");
  EXPECT_EQ(general(6.99999f), "6.99999");
  EXPECT_EQ(general(123456.7f), "123457");
  std::mt19937 random(2);
  for (int i = 0; i < 100000; ++i) {
    const auto value = static_cast<float>(
        std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), int(random() % 60) - 40));
    ASSERT_EQ(general(value), printed("%g", value));
  }
}

TEST(NumberFormat, aShortNumberIsParsedAsTheStandardLibraryDoes) {
  std::mt19937 random(3);
  const auto agrees = [](const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    const auto parsed = parseNumber(text);
    return parsed && *parsed == value && std::signbit(*parsed) == std::signbit(value);
  };
  for (const char* text : {"0", "-0", "-0.00", "007.50", "5.", ".25", "-.5", "999999999999999",
                           "0.1234567890123", "9999999999.9999", "123456789012345678", "0.3"})
    EXPECT_TRUE(agrees(text)) << text;
  for (int i = 0; i < 100000; ++i) {
    const double value =
        std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random), int(random() % 50) - 20);
    ASSERT_TRUE(agrees(fixed(value, int(random() % 8)))) << value;
  }
  for (const char* text : {"1.2.3", "--1", "-", "1-", ".", "-.", "1..2"})
    EXPECT_FALSE(parseNumber(text)) << text;
}

TEST(NumberFormat, parsesWholeFiniteNumbersOnly) {
  EXPECT_EQ(parseNumber("-12.50"), -12.5);
  EXPECT_EQ(parseNumber("+1e3"), 1000);
  EXPECT_EQ(parseNumber(".5"), 0.5);
  for (const char* text : {"", "+", "-", "1x", "1 ", " 1", "nan", "inf", "-inf", "1e999", "0x10", "1,5"})
    EXPECT_FALSE(parseNumber(text)) << text;
  EXPECT_EQ(parseInteger("-7"), -7);
  for (const char* text : {"", "1.0", "99999999999", "a"}) EXPECT_FALSE(parseInteger(text)) << text;
}

}  // namespace
}  // namespace plumbline::simspark
