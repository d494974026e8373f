#include "math/Gaussians.h"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline {
namespace {

TEST(Gaussians, haveMeanZeroAndDeviationOne) {
  Random random(4);
  std::vector<double> numbers(100'001);
  fillGaussian(random, numbers);
  double sum = 0, squares = 0, neighbours = 0;
  for (const double x : numbers) sum += x, squares += x * x;
  // Two are made together.
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) neighbours += numbers[i] * numbers[i + 1];
  EXPECT_NEAR(sum / 100'001, 0, 0.01);
  EXPECT_NEAR(squares / 100'001, 1, 0.015);
  EXPECT_NEAR(neighbours / 50'000, 0, 0.015);
}

}  // namespace
}  // namespace plumbline
