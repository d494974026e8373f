#include "modules/modeling/ground/SupportOdometry.h"

#include <gtest/gtest.h>

#include <array>

using namespace plumbline;

namespace {

constexpr double dt = 0.02;

TEST(SupportOdometry, theTorsoMovesOverAFootThatStandsStill) {
  SupportOdometry odometry;
  // The foot is fixed in the world; the torso goes along an arc, turns and leans.
  const Vec3 foot(0.1, 0.05, 0);
  const auto place = [](double s) { return Pose2(0.2 * s, 0.1 * s * s, 0.4 * s); };
  for (int i = 0; i < 30; ++i) {
    const double s = i / 30.0;
    const Pose3 torso = translation(place(s).x(), place(s).y(), 0.35) * rotationZ(0.4 * s) *
                        rotationY(0.2 * s) * rotationX(-0.1 * s);
    const std::array<Pose3, 1> links = {torso.inverse() * translation(foot)};
    const std::array<SupportOdometry::Contact, 1> contacts = {{{0, Vec3::Zero(), 45}}};
    const Pose2 step = odometry.update(torso.linear(), links, contacts, dt);
    if (i == 0) {
      EXPECT_EQ(step.position, Vec2(0, 0));
      continue;
    }
    const Pose2 truth = place(s - 1 / 30.0).inverse() * place(s);
    EXPECT_LT((step.position - truth.position).norm(), 1e-12);
    EXPECT_NEAR(step.heading, truth.heading, 1e-12);
  }
}

TEST(SupportOdometry, feetCountByTheirLoad) {
  SupportOdometry odometry;
  std::array<Pose3, 2> links = {Pose3::Identity(), Pose3::Identity()};
  odometry.update(Mat3::Identity(), links, {}, dt);
  links[0] = translation(-0.01, 0, 0);
  links[1] = translation(-0.02, 0, 0);
  const std::array<SupportOdometry::Contact, 2> contacts = {{{0, Vec3::Zero(), 30}, {1, Vec3::Zero(), 10}}};
  EXPECT_NEAR(odometry.update(Mat3::Identity(), links, contacts, dt).x(), 0.0125, 1e-12);
}

TEST(SupportOdometry, inTheAirTheSpeedGoesOnForALittle) {
  SupportOdometry odometry(0.101);
  std::array<Pose3, 1> links = {Pose3::Identity()};
  const std::array<SupportOdometry::Contact, 1> contact = {{{0, Vec3::Zero(), 45}}};
  odometry.update(Mat3::Identity(), links, contact, dt);
  links[0] = translation(-0.01, 0, 0);
  odometry.update(Mat3::Identity(), links, contact, dt);
  double way = 0;
  for (int i = 0; i < 50; ++i) way += odometry.update(Mat3::Identity(), links, {}, dt).x();
  EXPECT_NEAR(way, 0.05, 1e-9) << "five cycles of a centimetre";
}

TEST(SupportOdometry, resetStartsAnew) {
  SupportOdometry odometry;
  std::array<Pose3, 1> links = {Pose3::Identity()};
  const std::array<SupportOdometry::Contact, 1> contact = {{{0, Vec3::Zero(), 45}}};
  odometry.update(Mat3::Identity(), links, contact, dt);
  odometry.reset();
  links[0] = translation(-0.5, 0, 0);
  EXPECT_EQ(odometry.update(Mat3::Identity(), links, contact, dt).position, Vec2(0, 0));
}

}  // namespace
