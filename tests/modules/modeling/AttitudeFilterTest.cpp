#include "modules/modeling/attitude/AttitudeFilter.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/Angle.h"

using namespace plumbline;

namespace {

constexpr double dt = 0.02;
const Vec3 gravity(0, 0, 9.81);

/// A body whose sensors read as in SimSpark: gyro of the last step, accelerometer one cycle late.
struct Body {
  Mat3 R = Mat3::Identity();
  Vec3 lateAcc = gravity;
  Vec3 gyro = Vec3::Zero();

  /// Turns for a cycle; acceleration: of the torso in the world, besides gravity.
  void turn(const Vec3& rate, const Vec3& acceleration = Vec3::Zero()) {
    lateAcc = R.transpose() * (gravity + acceleration);
    const double angle = rate.norm() * dt;
    if (angle > 0) R = R * Eigen::AngleAxisd(angle, rate.normalized()).toRotationMatrix();
    gyro = rate;
  }
  double tiltError(const AttitudeFilter& filter) const {
    return toDegrees(std::acos(std::min(1.0, filter.up().dot(Vec3(R.row(2))))));
  }
};

Vec3 roundedGyro(const Vec3& gyro) {
  const double step = fromDegrees(0.01);
  return (gyro / step).array().round() * step;
}

TEST(AttitudeFilter, anglesFollowTheirConvention) {
  AttitudeFilter filter;
  Body body;
  const auto turn = [&](const Vec3& angle) {
    for (int i = 0; i < 25; ++i) {
      body.turn(angle / 25 / dt);
      filter.update(body.gyro, body.lateAcc, dt);
    }
  };
  turn(Vec3(0, 0, pi / 2));  // left
  turn(Vec3(0, 0.5, 0));     // lean forward
  turn(Vec3(0.3, 0, 0));     // then to the right
  EXPECT_NEAR(filter.heading(), pi / 2, 5e-3);
  EXPECT_NEAR(filter.pitch(), 0.5, 1e-3);
  EXPECT_NEAR(filter.roll(), 0.3, 1e-3);
  EXPECT_LT(filter.up().x(), 0) << "leaning forward, up is behind";
}

TEST(AttitudeFilter, staysExactThroughMinutesOfSwayWithRoundedSensors) {
  AttitudeFilter filter;
  Body body;
  filter.update(body.gyro, body.lateAcc, dt);  // standing
  double worst = 0;
  for (int i = 0; i < 6000; ++i) {  // two minutes of a walk's sway, with its accelerations
    const double t = i * dt, side = 2 * pi * 2.7 * t, step = 2 * pi * 5.3 * t;
    const Vec3 sway(0.5 * std::cos(side), 0.4 * std::sin(step), 0.3 * std::sin(0.3 * t));
    const Vec3 push(3 * std::sin(step), 4 * std::cos(side), 5 * std::sin(step));
    body.turn(sway, push);
    filter.update(roundedGyro(body.gyro), body.lateAcc, dt);
    worst = std::max(worst, body.tiltError(filter));
  }
  EXPECT_LT(worst, 0.3);
}

TEST(AttitudeFilter, firstReadingOfGravityIsBelieved) {
  AttitudeFilter filter;
  Body body;
  body.R = (rotationZ(1) * rotationY(fromDegrees(-88)) * rotationX(0.2)).linear();  // on its back
  body.turn(Vec3::Zero());
  filter.update(body.gyro, body.lateAcc, dt);
  EXPECT_LT(body.tiltError(filter), 1e-4);
}

TEST(AttitudeFilter, freeFallAtTheStartTellsNothing) {
  AttitudeFilter filter;
  for (int i = 0; i < 20; ++i) filter.update(Vec3::Zero(), Vec3::Zero(), dt);
  EXPECT_EQ(filter.up(), Vec3::UnitZ());
  EXPECT_FALSE(filter.still());
}

TEST(AttitudeFilter, aRobotPutDownDifferentlyIsRightOnceStill) {
  AttitudeFilter filter;
  Body body;
  const auto stay = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      body.turn(Vec3::Zero());
      filter.update(body.gyro, body.lateAcc, dt);
    }
  };
  stay(20);
  body.R = rotationX(fromDegrees(80)).linear();  // no sensor has measured it
  stay(70);
  EXPECT_TRUE(filter.still());
  EXPECT_LT(body.tiltError(filter), 1);
}

TEST(AttitudeFilter, aLostOrientationIsFoundWhileMoving) {
  AttitudeFilter filter;
  Body body;
  int cycle = 0;
  const auto walk = [&](int cycles) {
    for (int i = 0; i < cycles; ++i) {
      const double phase = 2 * pi * 2.7 * dt * ++cycle;
      body.turn(Vec3(0.5 * std::cos(phase), 0, 0), Vec3(0, 3 * std::cos(phase), 0));
      filter.update(body.gyro, body.lateAcc, dt);
    }
  };
  walk(100);
  body.R = (rotationY(fromDegrees(85)) * Pose3(Eigen::Quaterniond(body.R))).linear();
  EXPECT_GT(body.tiltError(filter), 80);
  walk(150);
  EXPECT_LT(body.tiltError(filter), 5);
  walk(250);
  EXPECT_LT(body.tiltError(filter), 2);
}

TEST(AttitudeFilter, badNumbersChangeNothing) {
  AttitudeFilter filter;
  filter.update(Vec3(0, 0.1, 0), gravity, dt);
  const Mat3 before = filter.rotation();
  filter.update(Vec3(0, std::numeric_limits<double>::quiet_NaN(), 0), gravity, dt);
  filter.update(Vec3(0, 0.1, 0), gravity, 0);
  EXPECT_EQ(filter.rotation(), before);
}

}  // namespace
