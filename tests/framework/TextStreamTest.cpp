#include "framework/TextStream.h"

#include <gtest/gtest.h>

#include <limits>

#include "framework/StreamExamples.h"

namespace plumbline {
namespace {

TEST(TextStreamTest, writesTheExampleOfTheSpecification) {
  EXPECT_EQ(toText(Example()), "{[a] 0 [b] 3 [v] 5.820000 [vec] {[x] 2.000000 [y] -1.500000 }}");
}

TEST(TextStreamTest, writesEveryType) {
  EXPECT_EQ(
      toText(Everything()),
      "{[flag] true [letter] 'x' [small] -5 [medium] 65535 [large] -9000000000 "
      "[huge] 18446744073709551615 [real] 0.100000 [colour] 2 "
      "[text] \"say \\\"hi\\\" \\\\ {now}\\n\\x01\" [three] {1 2 3 } "
      "[list] {{[a] 0 [b] 3 [v] 5.820000 [vec] {[x] 2.000000 [y] -1.500000 }} "
      "{[a] 0 [b] 3 [v] 5.820000 [vec] {[x] 2.000000 [y] -1.500000 }}} "
      "[bits] {true false } [some] {0.3333333333333333 } [none] {} "
      "[pair] {[first] 7 [second] 1e-09 } "
      "[matrix] {{0.500000 0.500000 0.500000 } {0.500000 0.500000 0.500000 }} "
      "[six] {0.000000 0.200000 0.400000 0.6000000000000001 0.800000 1.000000 } "
      "[pose] {[rotation] {{0.955336489125606 0.000000 0.29552020666133955 } {0.000000 1.000000 0.000000 } "
      "{-0.29552020666133955 0.000000 0.955336489125606 }} "
      "[translation] {[x] 1.000000 [y] 2.000000 [z] 3.000000 }} "
      "[turn] {[x] 0.500000 [y] -0.500000 [z] 0.500000 [w] 0.500000 }}");
}

TEST(TextStreamTest, readsBackWhatItWrote) {
  Everything changed;
  changed.list.clear();
  changed.three = {};
  changed.text = "";
  changed.some = std::nullopt;
  changed.none = 5;
  changed.turn.setIdentity();
  changed.pose.setIdentity();
  changed.pair = {};
  EXPECT_EQ(fromText(toText(Everything()), changed), "");
  EXPECT_EQ(toText(changed), toText(Everything()));
  EXPECT_EQ(changed.pair.second, 1e-9);
  EXPECT_EQ(changed.some, 1.0 / 3);
  EXPECT_EQ(changed.text, "say \"hi\" \\ {now}\n\x01");
}

TEST(TextStreamTest, realNumbersSurvive) {
  for (const double value : {0.0, -0.5, 1e-300, 1e300, 1.0 / 3, 123456789.125, 1e15, 5.82}) {
    double back = 7;
    EXPECT_EQ(fromText(toText(value), back), "");
    EXPECT_EQ(back, value);
  }
  double infinite = 0;
  EXPECT_EQ(fromText(toText(-std::numeric_limits<double>::infinity()), infinite), "");
  EXPECT_EQ(infinite, -std::numeric_limits<double>::infinity());
}

TEST(TextStreamTest, labelsAndSpacesDoNotMatterWhenReading) {
  Example example;
  EXPECT_EQ(fromText(" { 1\n[whatever] 2 [] 3{4 5}}\t", example), "");
  EXPECT_EQ(example.a, 1);
  EXPECT_EQ(example.b, 2);
  EXPECT_EQ(example.v, 3);
  EXPECT_EQ(example.p, Eigen::Vector2d(4, 5));
}

template <typename T>
std::string errorOf(const std::string& text) {
  T value{};
  return fromText(text, value);
}

TEST(TextStreamTest, saysWhatIsWrongAndWhere) {
  EXPECT_EQ(errorOf<Example>(""), "byte 0: expected {, found the end");
  EXPECT_EQ(errorOf<Example>("{1 2 x {0 0}}"), "byte 5: expected a number, found \"x\"");
  EXPECT_EQ(errorOf<Example>("{1 2 3 {0 0"), "byte 11: expected }, found the end");
  EXPECT_EQ(errorOf<Example>("{1 2 3 {0 0 0}}"), "byte 12: expected }, found \"0\"");
  EXPECT_EQ(errorOf<Example>("{1 2 3 {0 0}} 4"), "byte 14: text left over");
  EXPECT_EQ(errorOf<Example>("{1.5 2 3 {0 0}}"), "byte 1: expected an integer of 4 bytes, found \"1.5\"");
  EXPECT_EQ(errorOf<Example>("{3000000000 2 3 {0 0}}"),
            "byte 1: expected an integer of 4 bytes, found \"3000000000\"");
  EXPECT_EQ(errorOf<std::uint8_t>("256"), "byte 0: expected an unsigned integer of 1 bytes, found \"256\"");
  EXPECT_EQ(errorOf<std::int8_t>("-129"), "byte 0: expected an integer of 1 bytes, found \"-129\"");
  EXPECT_EQ(errorOf<bool>("yes"), "byte 0: expected true or false, found \"yes\"");
  EXPECT_EQ(errorOf<Colour>("3"), "byte 1: enum value 3 out of range");
  EXPECT_EQ(errorOf<std::string>("abc"), "byte 0: expected a string in double quotes, found \"abc\"");
  EXPECT_EQ(errorOf<std::string>("\"abc"), "byte 4: missing closing quote");
  EXPECT_EQ(errorOf<std::string>("\"\\xg0\""), "byte 2: \\x needs two hexadecimal digits");
  EXPECT_EQ(errorOf<char>("'ab'"), "byte 0: expected one character in single quotes");
  EXPECT_EQ(errorOf<std::optional<int>>("{1 2}"), "byte 3: an optional value holds one element at most");
}

TEST(TextStreamTest, anErrorLeavesTheValueAsItWas) {
  Example example;
  example.a = 77;
  EXPECT_NE(fromText("{1 2 3 {4 x}}", example), "");
  EXPECT_EQ(example.a, 77);
  EXPECT_EQ(example.p, Eigen::Vector2d(2, -1.5));
}

}  // namespace
}  // namespace plumbline
