#include "optimization/Brent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline {
namespace {

Bracket bracketOf(const std::function<double(double)>& f, double lo, double x, double hi) {
  return {lo, x, hi, f(lo), f(x), f(hi)};
}

TEST(BrentTest, aParabolaTakesOneStep) {
  int calls = 0;
  const auto f = [&](double x) { return ++calls, (x - 0.7) * (x - 0.7); };
  const Bracket bracket = bracketOf(f, -1, 0, 2);
  calls = 0;
  EXPECT_NEAR(minimizeBrent(f, bracket, 1e-6, 3), 0.7, 2e-6);
  EXPECT_EQ(calls, 3);
}

TEST(BrentTest, aKinkIsFoundByGoldenSections) {
  const auto f = [](double x) { return std::abs(x - 0.3) + (x > 0.3 ? 3 * (x - 0.3) : 0); };
  EXPECT_NEAR(minimizeBrent(f, bracketOf(f, -2, 0, 5), 1e-4, 60), 0.3, 4e-4);
}

TEST(BrentTest, staysWithinTheBracketAndTheBudget) {
  int calls = 0;
  const auto f = [&](double x) {
    EXPECT_GE(x, 0);
    EXPECT_LE(x, 4);
    ++calls;
    return std::cosh(x - 3.2);
  };
  const Bracket bracket = bracketOf(f, 0, 2, 4);
  calls = 0;
  EXPECT_NEAR(minimizeBrent(f, bracket, 1e-8, 5), 3.2, 0.02);
  EXPECT_EQ(calls, 5);
}

TEST(BrentTest, aBracketIsFollowedToWhereItRises) {
  std::vector<double> tried;
  const auto f = [&](double x) { return tried.push_back(x), (x - 5) * (x - 5); };
  const Bracket b = bracketFrom(f, -1, 0, 1, -10, 10, 6);
  EXPECT_EQ(tried, (std::vector<double>{0, -1, 1, 2.6, 5.16, 9.256}));
  EXPECT_DOUBLE_EQ(b.lo, 2.6);
  EXPECT_DOUBLE_EQ(b.x, 5.16);
  EXPECT_DOUBLE_EQ(b.hi, 9.256);
  EXPECT_LT(b.fx, std::min(b.fLo, b.fHi));
}

TEST(BrentTest, aBracketEndsAtTheRangeAndAtItsBudget) {
  const auto f = [](double x) { return x; };
  const Bracket atEnd = bracketFrom(f, -1, 0, 1, -2, 10, 6);
  EXPECT_EQ(atEnd.lo, -2);
  EXPECT_EQ(atEnd.x, -1);
  EXPECT_EQ(atEnd.fLo, -2);
  EXPECT_DOUBLE_EQ(bracketFrom(f, -1, 0, 1, -100, 10, 2).lo, -1 - 1.6 - 2.56);
}

}  // namespace
}  // namespace plumbline
