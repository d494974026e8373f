#include "modules/communication/code/SayAlphabet.h"

#include <gtest/gtest.h>

#include "math/Random.h"
#include "simspark/AgentCommand.h"

using namespace plumbline;

namespace {

TEST(SayBitsTest, allBitsComeBack) {
  Random random(1);
  for (int run = 0; run < 100; ++run) {
    SayBits bits;
    std::vector<std::pair<std::uint32_t, int>> written;
    for (int left = SayBits::numBits; left > 0;) {
      const int count = std::min(left, 1 + static_cast<int>(random.next() % 32));
      const auto value = static_cast<std::uint32_t>(random.next()) & (count == 32 ? ~0u : (1u << count) - 1);
      bits.write(value, count);
      written.emplace_back(value, count);
      left -= count;
    }
    const std::string text = bits.text();
    ASSERT_EQ(text.size(), 20u);
    ASSERT_TRUE(simspark::isSayable(text)) << text;
    auto read = SayBits::fromText(text);
    ASSERT_TRUE(read);
    for (const auto& [value, count] : written) ASSERT_EQ(read->read(count), value);
  }
}

TEST(SayBitsTest, moreThan120BitsAreAnError) {
  SayBits bits;
  for (int i = 0; i < 4; ++i) bits.write(0, 29);
  try {
    bits.write(0, 5);
    FAIL() << "121 bits were written";
  } catch (const std::length_error& error) {
    EXPECT_STREQ(error.what(), "a message has 120 bits; 116 are used, 5 more were to be written");
  }
}

TEST(SayBitsTest, otherTextsAreNone) {
  EXPECT_FALSE(SayBits::fromText(""));
  EXPECT_FALSE(SayBits::fromText("AAAAAAAAAAAAAAAAAAA"));
  EXPECT_FALSE(SayBits::fromText("AAAAAAAAAAAAAAAAAAAAA"));
  EXPECT_FALSE(SayBits::fromText("AAAAAAAAAAAAAAAAAAA/"));
  EXPECT_TRUE(SayBits::fromText("AAAAAAAAAAAAAAAAAAAA"));
}

TEST(QuantiseTest, isOffByHalfAStepAtMost) {
  for (double value = -16; value < 16; value += 0.013)
    EXPECT_NEAR(unquantise(quantise(value, -16, 16, 9), -16, 16, 9), value, 32.0 / 512 / 2 + 1e-12);
}

TEST(QuantiseTest, whatIsBeyondTheLimitsOrNoNumberIsBounded) {
  EXPECT_EQ(quantise(1e9, -16, 16, 9), 511u);
  EXPECT_EQ(quantise(-1e9, -16, 16, 9), 0u);
  EXPECT_EQ(quantise(std::nan(""), -16, 16, 9), 0u);
}

}  // namespace
