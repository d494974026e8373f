#include "walking/model/LinearInvertedPendulum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::walking {
namespace {

constexpr double pendulumHeight = 0.25;
const double k = std::sqrt(9.81 / pendulumHeight);

WalkState onLeft(const Pose2& foot, const Vec2& velocity) {
  WalkState state;
  state.support = Support::left;
  state.foot = {foot, Pose2(0, -0.05)};
  state.velocity = velocity;
  return state;
}

WalkAction lasting(double duration) {
  WalkAction action;
  action.duration = duration;
  return action;
}

TEST(LinearInvertedPendulum, isEquations41And42) {
  const LinearInvertedPendulum model(pendulumHeight);
  const WalkState end = model.move(onLeft(Pose2(0.03, 0.05), Vec2(0.2, 0.1)), lasting(0.3), 0.2);
  // x of the equations is the mass relative to the foot, the state has the foot relative to the mass.
  EXPECT_NEAR(-end.foot[0].x(), -0.03 * std::cosh(k * 0.2) + 0.2 / k * std::sinh(k * 0.2), 1e-12);
  EXPECT_NEAR(-end.foot[0].y(), -0.05 * std::cosh(k * 0.2) + 0.1 / k * std::sinh(k * 0.2), 1e-12);
  EXPECT_NEAR(end.velocity.x(), -0.03 * k * std::sinh(k * 0.2) + 0.2 * std::cosh(k * 0.2), 1e-12);
  EXPECT_NEAR(end.velocity.y(), -0.05 * k * std::sinh(k * 0.2) + 0.1 * std::cosh(k * 0.2), 1e-12);
}

TEST(LinearInvertedPendulum, aMassNearTheGroundFallsAsOneTwoCentimetresUp) {
  const auto end = [](double height) {
    return LinearInvertedPendulum(height).move(onLeft(Pose2(0.01, 0.02), Vec2(0.2, 0.1)), lasting(0.3), 0.1);
  };
  for (const double height : {-0.1, 0.0, 0.01, 0.0199})
    EXPECT_EQ(end(height).velocity, end(0.02).velocity) << height;
  EXPECT_NE(end(0.021).velocity, end(0.02).velocity);
}

TEST(LinearInvertedPendulum, agreesWithIntegration) {
  const LinearInvertedPendulum model(pendulumHeight, Vec2(0.01, -0.005));
  const WalkState begin = onLeft(Pose2(-0.02, 0.06, 0.1), Vec2(0.4, 0.15));
  const Vec2 pivot = Pose2(-0.02, 0.06, 0.1) * Vec2(0.01, -0.005);
  Vec2 com = Vec2::Zero(), velocity = begin.velocity;
  constexpr int steps = 200000;
  constexpr double h = 0.18 / steps;
  for (int i = 0; i < steps; ++i) {
    velocity += h * k * k * (com - pivot);
    com += h * velocity;
  }
  const WalkState end = model.move(begin, lasting(0.18), 0.18);
  EXPECT_NEAR((end.velocity - velocity).norm(), 0, 1e-5);
  EXPECT_NEAR((end.foot[0].position - (Vec2(-0.02, 0.06) - com)).norm(), 0, 1e-5);
}

TEST(LinearInvertedPendulum, aMoveInTwoPartsIsTheWholeMove) {
  const LinearInvertedPendulum model(pendulumHeight, Vec2(0.01, -0.005));
  const WalkState begin = onLeft(Pose2(0.02, 0.06, 0.2), Vec2(0.4, 0.15));
  WalkAction whole = lasting(0.2), half = lasting(0.1);
  whole.turn = 0.3;
  half.turn = 0.15;
  const WalkState once = model.move(begin, whole, 0.2);
  const WalkState twice = model.move(model.move(begin, half, 0.1), half, 0.1);
  EXPECT_NEAR((once.velocity - twice.velocity).norm(), 0, 1e-12);
  EXPECT_NEAR((once.foot[0].position - twice.foot[0].position).norm(), 0, 1e-12);
  EXPECT_NEAR(once.foot[0].heading, twice.foot[0].heading, 1e-12);
  EXPECT_NEAR(once.foot[0].heading, 0.2 - 0.3, 1e-12) << "the torso turned left over the foot";
}

TEST(LinearInvertedPendulum, keepsTheOrbitalEnergy) {
  const LinearInvertedPendulum model(pendulumHeight);
  const WalkState begin = onLeft(Pose2(0.05, 0.06), Vec2(0.5, 0.2));
  const auto energy = [](const WalkState& s) {
    return Vec2(s.velocity.cwiseAbs2() - k * k * s.foot[0].position.cwiseAbs2());
  };
  EXPECT_NEAR((energy(model.move(begin, lasting(0.25), 0.25)) - energy(begin)).norm(), 0, 1e-12);
}

TEST(LinearInvertedPendulum, aStepEndsOnTheOtherFoot) {
  const LinearInvertedPendulum model(pendulumHeight);
  WalkAction action = lasting(0.2);
  action.stepTarget = Pose2(0.04, -0.06, 0.1);
  const WalkState end = model.predict(onLeft(Pose2(0, 0.05), Vec2(0, 0.1)), action);
  EXPECT_EQ(end.support, Support::right);
  EXPECT_DOUBLE_EQ(end.foot[1].x(), 0.04);
  EXPECT_DOUBLE_EQ(end.foot[1].heading, 0.1);
}

TEST(LinearInvertedPendulum, doubleSupportLeavesItsCentreOfPressure) {
  const LinearInvertedPendulum model(pendulumHeight);
  WalkState state;
  state.foot = {Pose2(0, 0.05), Pose2(0, -0.05)};
  WalkAction action = lasting(0.1);
  action.centerOfPressure = Vec2(-0.02, 0.03);
  const WalkState end = model.predict(state, action);
  EXPECT_EQ(end.support, Support::both);
  EXPECT_NEAR(end.velocity.x(), 0.02 * k * std::sinh(k * 0.1), 1e-12);
  EXPECT_NEAR(end.velocity.y(), -0.03 * k * std::sinh(k * 0.1), 1e-12);
}

/// The ten parameters one by one against what they mean.
class FittedPendulum : public testing::Test {
protected:
  const WalkState begin = onLeft(Pose2(-0.03, 0.05), Vec2(0.2, 0.1));
  const WalkAction action = lasting(0.15);
  ModelParameters fit;
  WalkState end() const {
    return LinearInvertedPendulum(pendulumHeight, Vec2::Zero(), fit).move(begin, action, 0.15);
  }
  WalkState plain(const WalkState& state, double h = pendulumHeight, double time = 0.15) const {
    return LinearInvertedPendulum(h).move(state, action, time);
  }
};

TEST_F(FittedPendulum, neutralValuesChangeNothing) {
  EXPECT_EQ(end().velocity, plain(begin).velocity);
  EXPECT_EQ(end().foot[0].position, plain(begin).foot[0].position);
  for (std::size_t i = 0; i < ModelParameters::count; ++i)
    EXPECT_DOUBLE_EQ(fit.values()[i], modelParameterTable[i].neutral) << modelParameterTable[i].name;
}

TEST_F(FittedPendulum, anOffsetOfTheMassMovesTheFootTheOtherWay) {
  fit.massOffsetX = 0.01;
  fit.massOffsetY = -0.004;
  WalkState moved = begin;
  moved.foot[0].position -= Vec2(0.01, -0.004);
  EXPECT_NEAR((end().velocity - plain(moved).velocity).norm(), 0, 1e-12);
  EXPECT_NEAR((end().foot[0].position - plain(moved).foot[0].position - Vec2(0.01, -0.004)).norm(), 0, 1e-12);
}

TEST_F(FittedPendulum, heightsOfBothDirectionsAreSeparate) {
  fit.massOffsetZx = 0.05;
  fit.massOffsetZy = -0.05;
  EXPECT_NEAR(end().velocity.x(), plain(begin, pendulumHeight + 0.05).velocity.x(), 1e-12);
  EXPECT_NEAR(end().velocity.y(), plain(begin, pendulumHeight - 0.05).velocity.y(), 1e-12);
}

TEST_F(FittedPendulum, velocityOffsetIsOfTheEstimate) {
  fit.velocityOffsetX = 0.03;
  fit.velocityOffsetY = -0.02;
  WalkState faster = begin;
  faster.velocity += Vec2(0.03, -0.02);
  EXPECT_NEAR((end().velocity + Vec2(0.03, -0.02) - plain(faster).velocity).norm(), 0, 1e-12);
  EXPECT_NEAR((end().foot[0].position - plain(faster).foot[0].position).norm(), 0, 1e-12);
}

TEST_F(FittedPendulum, footFactorsScaleTheDistance) {
  fit.footFactor = 1.1;
  fit.footFactorX = 0.9;
  WalkState scaled = begin;
  scaled.foot[0].position = Vec2(1.1 * 0.9 * -0.03, 1.1 * 0.05);
  const WalkState moved = plain(scaled);
  EXPECT_NEAR((end().velocity - moved.velocity).norm(), 0, 1e-12);
  EXPECT_NEAR(end().foot[0].x(), moved.foot[0].x() / (1.1 * 0.9), 1e-12);
  EXPECT_NEAR(end().foot[0].y(), moved.foot[0].y() / 1.1, 1e-12);
}

TEST_F(FittedPendulum, timeFactorLetsThePendulumsTimePassFaster) {
  fit.timeFactor = 1.2;
  EXPECT_NEAR((end().velocity - plain(begin, pendulumHeight, 0.18).velocity).norm(), 0, 1e-12);
}

TEST_F(FittedPendulum, aMoveInTwoPartsIsTheWholeMove) {
  fit = ModelParameters::of({0.01, -0.004, 0.02, -0.03, 0.03, -0.02, 0.9, 1.05, 1.1, 1.2});
  const LinearInvertedPendulum model(pendulumHeight, Vec2::Zero(), fit);
  const WalkState twice = model.move(model.move(begin, action, 0.07), action, 0.08);
  EXPECT_NEAR((end().velocity - twice.velocity).norm(), 0, 1e-12);
  EXPECT_NEAR((end().foot[0].position - twice.foot[0].position).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace plumbline::walking
