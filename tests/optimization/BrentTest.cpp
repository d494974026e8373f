#include "optimization/Brent.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace plumbline
