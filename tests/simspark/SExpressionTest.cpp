#include "simspark/SExpression.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace plumbline::simspark {
namespace {

/// The trees again as text, to compare them at a glance.
std::string written(SExpressions::Node node) {
  std::string out;
  for (; node; node = node.next()) {
    if (!out.empty()) out += ' ';
    out += node.isList() ? '(' + written(node.first()) + ')' : std::string(node.text());
  }
  return out;
}

TEST(SExpressions, keepsTheTrees) {
  SExpressions s;
  ASSERT_TRUE(s.parse("(ball(pos 1  2\t3)\n(vel))(say x) atom ()"));
  EXPECT_EQ(written(s.first()), "(ball (pos 1 2 3) (vel)) (say x) atom ()");
  const auto ball = s.first();
  EXPECT_EQ(ball.name(), "ball");
  EXPECT_EQ(ball.list("pos").at(3).text(), "3");
  EXPECT_FALSE(ball.list("pos").at(4));
  EXPECT_FALSE(ball.list("ball"));
  EXPECT_FALSE(ball.list("none").at(1)) << "asking an absent node gives an absent node";
  EXPECT_EQ(ball.next().next().name(), "") << "an atom has no name";
}

TEST(SExpressions, errorsAndWhatIsLeft) {
  SExpressions s({.depth = 3, .nodes = 10});
  EXPECT_FALSE(s.parse("(a)(b (c"));
  EXPECT_EQ(s.error(), "a parenthesis is not closed");
  EXPECT_EQ(s.errorPosition(), 8u);
  EXPECT_EQ(written(s.first()), "(a)") << "half a command is none";
  EXPECT_FALSE(s.parse("(a)) (b)"));
  EXPECT_EQ(s.error(), "a closing parenthesis without an opening one");
  EXPECT_EQ(s.errorPosition(), 3u);
  EXPECT_EQ(written(s.first()), "(a)");
  EXPECT_TRUE(s.parse("(((a)))"));
  EXPECT_FALSE(s.parse("(x)((((a))))"));
  EXPECT_EQ(s.error(), "nested too deeply");
  EXPECT_EQ(written(s.first()), "(x)");
  EXPECT_FALSE(s.parse("a b c d e f g h i j k"));
  EXPECT_EQ(s.error(), "too many elements");
  EXPECT_TRUE(s.parse(""));
  EXPECT_FALSE(s.first());
}

TEST(SExpressions, survivesAnything) {
  std::mt19937 random(5);
  SExpressions s({.depth = 8, .nodes = 64});
  int good = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (unsigned n = random() % 40; n > 0; --n) text += "()()()  ab1.\0\xff"[random() % 14];
    good += s.parse(text);
    written(s.first());
  }
  EXPECT_GT(good, 500);
  EXPECT_LT(good, 19500);
}

}  // namespace
}  // namespace plumbline::simspark
