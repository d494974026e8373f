#include "math/Angle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "math/Random.h"

namespace plumbline {
namespace {

/// As the standard library has it, for any angle.
double byRemainder(double angle) {
  const double wrapped = std::remainder(angle, 2.0 * pi);
  return wrapped <= -pi ? pi : wrapped;
}

std::uint64_t bitsOf(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(AngleTest, theShortWayToANormalAngleGivesTheSameBits) {
  std::vector<double> angles = {0.0, -0.0, 1e-300, 9, -9, 1e9, -1e9};
  for (const double turns : {0.5, 1.0, 1.5, 2.0, 2.5})
    for (const double angle : {turns * 2 * pi, -turns * 2 * pi})
      for (const double near : {angle, std::nextafter(angle, 100), std::nextafter(angle, -100)})
        angles.push_back(near);
  Random random(11);
  for (int i = 0; i < 100000; ++i) angles.push_back(random.uniform(-12, 12));
  for (const double angle : angles)
    ASSERT_EQ(bitsOf(normalizeAngle(angle)), bitsOf(byRemainder(angle))) << angle;
}

TEST(AngleTest, aNormalAngleIsAboveMinusPiAndAtMostPi) {
  EXPECT_EQ(normalizeAngle(pi), pi);
  EXPECT_EQ(normalizeAngle(-pi), pi);
  EXPECT_EQ(normalizeAngle(3), 3);
  EXPECT_NEAR(normalizeAngle(4), 4 - 2 * pi, 1e-15);
  EXPECT_TRUE(std::isnan(normalizeAngle(std::nan(""))));
}

}  // namespace
}  // namespace plumbline
